import { type Region, WHOLE } from './pixels.ts'

/** The forehead of the shipped face in the framing of `minimal.html`. */
export const FOREHEAD: Region = { left: 0.4, top: 0.14, right: 0.6, bottom: 0.36 }

/** The brows and the forehead in the framing of `portrait.js`. */
export const BROWS: Region = { left: 0.4, top: 0.1, right: 0.6, bottom: 0.3 }

/** The cheeks, with the corners of eyes and mouth, in the framing of `portrait.js`. */
export const CHEEKS: Region = { left: 0.25, top: 0.3, right: 0.75, bottom: 0.7 }

/** The face in the framing of `portrait.js`, in a window of 4:3. */
export const FACE: Region = { left: 0.16, top: 0.03, right: 0.84, bottom: 0.71 }

/** Values of controls by label: a number for a slider, `true` to press a button, radio button or checkbox. */
export type Controls = Record<string, number | true>

/** An example page, and how a test shows and removes its wrinkles. */
export interface Example {
  /** File name without `.html`. */
  page: string
  /** Query that makes the page show wrinkles. Pages without a query show wrinkles at the start or after 1.5 seconds. */
  query?: string
  /** Values of controls that remove the wrinkles; undefined if the page has no controls. */
  atRest?: Controls
  /** Region of the picture in which wrinkles appear. */
  region: Region
  /** Query for the picture in the gallery. Default: `query`. */
  picture?: string
  /** Part of the window that the picture in the gallery shows, 4:3. Default: `FACE`. */
  frame?: Region
  /** Whether something besides wrinkles moves after `query` has taken effect. */
  moves?: true
  /** Whether `npm test` opens the page. */
  quick?: true
  /** Whether the page imports packages from esm.sh. */
  cdn?: true
  /** Separate test file, for a page that the common test cannot check. */
  test?: string
}

/** All examples, sorted by name. The gallery and its tests read this table: a new page needs an entry. */
export const EXAMPLES: readonly Example[] = [
  { page: 'age', query: '?age=75', atRest: { age: 20 }, region: BROWS, quick: true },
  { page: 'auto', picture: '?age=75&expression=angry', region: BROWS, test: 'examples-auto.test.ts' },
  { page: 'babylon', atRest: { neutral: true }, region: BROWS },
  { page: 'babylon-material', query: '?coat=0.8', atRest: { neutral: true }, region: BROWS },
  { page: 'blood', query: '?expression=happy', atRest: { neutral: true }, region: CHEEKS },
  { page: 'clip', query: '?time=1', atRest: { time: 0 }, region: BROWS },
  { page: 'clones', frame: WHOLE, atRest: { neutral: true }, region: WHOLE },
  {
    page: 'clothes',
    query: '?clip=sit&time=1.6&zoom=2.2&height=-0.4&across=-0.2&view=-70',
    picture: '?clip=sit&time=1.6&zoom=1.2&height=-0.15&view=-65',
    frame: WHOLE,
    region: WHOLE,
  },
  {
    page: 'crowd',
    query: '?count=6',
    picture: '?count=40',
    frame: WHOLE,
    region: { left: 0.25, top: 0, right: 0.75, bottom: 1 },
    moves: true,
  },
  { page: 'decoders', atRest: { neutral: true }, region: FOREHEAD },
  { page: 'delay', atRest: { neutral: true }, region: BROWS },
  {
    page: 'distance',
    frame: WHOLE,
    query: '?fade=10&distance=0.3',
    picture: '',
    atRest: { neutral: true },
    region: WHOLE,
  },
  { page: 'environment', atRest: { neutral: true }, region: BROWS },
  { page: 'explain', picture: '?expression=angry', atRest: { neutral: true }, region: BROWS },
  {
    page: 'expressions',
    query: '?happy=0.7&surprised=0.6',
    atRest: { happy: 0, surprised: 0 },
    region: BROWS,
  },
  { page: 'folder', atRest: { neutral: true }, region: BROWS },
  {
    page: 'hand-tracking',
    query: '?fist=1',
    picture: '?fist=0.7',
    frame: { left: 0.2, top: 0.38, right: 0.8, bottom: 0.98 },
    atRest: { fist: 0 },
    region: { left: 0.4, top: 0.45, right: 0.6, bottom: 0.95 },
  },
  { page: 'influence', picture: '?show=foreheadLeft', atRest: { neutral: true }, region: BROWS },
  { page: 'inputs', query: '?stress=100', atRest: { stress: 0 }, region: BROWS },
  { page: 'inspector', picture: '?view=influence', frame: WHOLE, atRest: { neutral: true }, region: BROWS },
  { page: 'instances', frame: WHOLE, atRest: { 'head 4': 0, 'head 3': 0, 'head 2': 0 }, region: WHOLE },
  {
    page: 'joints',
    query: '?fist=1',
    frame: { left: 0.2, top: 0.38, right: 0.8, bottom: 0.98 },
    atRest: { fist: 0 },
    region: { left: 0.4, top: 0.45, right: 0.6, bottom: 0.95 },
  },
  {
    page: 'joints',
    query: '?model=neck&turn=1',
    atRest: { turn: 0 },
    region: { left: 0.5, top: 0.55, right: 0.65, bottom: 0.75 },
  },
  { page: 'key-frames', query: '?time=2.2', atRest: { seconds: 0 }, region: BROWS },
  { page: 'lights', atRest: { neutral: true }, region: BROWS },
  { page: 'links', query: '?browDownLeft=1&browDownRight=1', atRest: { browDownRight: 0 }, region: BROWS },
  {
    page: 'materials',
    query: '?material=Phong',
    picture: '?material=Matcap',
    atRest: { neutral: true },
    region: BROWS,
  },
  { page: 'microphone', query: '?loudness=1', atRest: { loudness: 0 }, region: BROWS },
  { page: 'minimal', region: FOREHEAD, quick: true },
  { page: 'modes', atRest: { neutral: true }, region: BROWS },
  {
    page: 'muscles',
    query: '?expression=surprise',
    picture: '?expression=disgust',
    atRest: { neutral: true },
    region: BROWS,
  },
  { page: 'node-material', query: '?rim=0.5', atRest: { neutral: true }, region: BROWS },
  {
    page: 'normals',
    query: '?mouthSmileLeft=1&mouthSmileRight=1',
    picture: '?cheekPuff=1&mouthPucker=0.7',
    atRest: { mouthSmileLeft: 0, mouthSmileRight: 0 },
    region: CHEEKS,
  },
  { page: 'own-driver', query: '?phase=0.5', atRest: { phase: 0 }, region: BROWS },
  { page: 'own-expression', atRest: { neutral: true }, region: BROWS },
  { page: 'paint', atRest: { clear: true }, region: BROWS },
  { page: 'physical', query: '?clearcoat=0.6', atRest: { neutral: true }, region: BROWS },
  { page: 'pointer', query: '?up=1', picture: '?up=1&across=0.5', atRest: { up: 0 }, region: BROWS },
  { page: 'postprocessing', query: '?bloom=0.25', atRest: { neutral: true }, region: BROWS },
  { page: 'react', cdn: true, atRest: { neutral: true }, region: FOREHEAD },
  {
    page: 'react-faces',
    cdn: true,
    frame: { left: 0.1, top: 0.2, right: 0.9, bottom: 1 },
    atRest: { neutral: true },
    region: WHOLE,
  },
  { page: 'relief', atRest: { neutral: true }, region: { left: 0.5, top: 0.1, right: 0.72, bottom: 0.35 } },
  { page: 'shader', query: '?hologram=1', atRest: { neutral: true }, region: BROWS, moves: true },
  { page: 'strength', query: '?normals=2', atRest: { neutral: true }, region: BROWS },
  { page: 'strokes', atRest: { clear: true }, region: BROWS },
  { page: 'sweat', atRest: { sweat: 0 }, region: BROWS },
  {
    page: 'tension',
    query: '?push=0.3',
    frame: { left: 0.15, top: 0.15, right: 0.85, bottom: 0.85 },
    atRest: { push: 0 },
    region: { left: 0.4, top: 0.3, right: 0.6, bottom: 0.8 },
    moves: true,
  },
  { page: 'toon', query: '?material=MToon', atRest: { neutral: true }, region: BROWS },
  { page: 'tracker', query: '?seconds=2', atRest: { seconds: 0 }, region: BROWS },
  { page: 'transmission', atRest: { neutral: true }, region: BROWS },
  {
    page: 'vrm',
    query: '?happy=1&blink=1',
    picture: '?happy=1',
    atRest: { happy: 0, blink: 0 },
    region: CHEEKS,
  },
  { page: 'webcam', query: '?seconds=4', atRest: { seconds: 0 }, region: CHEEKS },
  { page: 'webgpu', region: FOREHEAD, quick: true },
  { page: 'webgpu-postprocessing', query: '?bloom=0.2', atRest: { neutral: true }, region: BROWS },
  {
    page: 'wink',
    query: '?rightBrow=1',
    picture: '?leftWink=1&rightBrow=1',
    atRest: { rightBrow: 0 },
    region: BROWS,
  },
]

/** Returns the address that shows an example with its wrinkles, relative to the folder of examples. */
export function addressOf({ page, query = '' }: Example): string {
  return `${page}.html${query}`
}
