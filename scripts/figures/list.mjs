/**
 * Lists the pictures of all figures in the README and the docs. Figures 8, 9 and 10 have their numbers from the paper
 * (Reis, De Martino and Batagelo 2008).
 */

import { both, CLOSE_UPS } from './close-ups.mjs'
import { AGES, SKINS } from './faces.mjs'
import { FURROWS } from './furrows.mjs'
import { movingFrames, movingPictures } from './moving.mjs'
import { movingBodyFrames, movingBodyPictures } from './moving-body.mjs'

const PORTRAIT = { width: 900, height: 1050, crop: { left: 180, top: 50, width: 540, height: 720 } }
const STUDIO_PORTRAIT = {
  width: 480,
  height: 560,
  expression: 'surprised',
  crop: { left: 72, top: 40, width: 336, height: 336 },
  scale: 2 / 3,
}
const EYE = {
  width: 1600,
  height: 1200,
  view: 'close',
  crop: { left: 700, top: 330, width: 720, height: 540 },
}

const BROW = {
  width: 1600,
  height: 1200,
  view: 'close',
  targets: { browOuterUpLeft: 1, browInnerUp: 0.4 },
  crop: { left: 480, top: 130, width: 720, height: 480 },
}
const FOREHEAD = { ...PORTRAIT, expression: 'surprised', crop: { ...PORTRAIT.crop, height: 480 } }

const PAGE = { width: 720, height: 900, crop: { left: 135, top: 20, width: 450, height: 540 } }
/** Crop with a face on the left and the panel of the inspector on the right. */
const PANEL = { width: 900, height: 720, crop: { left: 220, top: 0, width: 680, height: 600 }, scale: 0.8 }
/**
 * Crop of the cheeks in examples/normals.html. The page must use WebGL 2: without a GPU, the browser cannot capture a
 * WebGPU canvas.
 */
const CHEEKS = { width: 1100, height: 1300, crop: { left: 300, top: 400, width: 500, height: 500 } }
const HAND = { width: 900, height: 900, crop: { left: 190, top: 130, width: 490, height: 660 } }
const CLOTHES = { width: 640, height: 900, crop: { left: 60, top: 40, width: 520, height: 640 } }
const AT_ELBOW = '&zoom=2.6&height=0.27&across=-0.1&view=-60'
const AT_WAIST = '&zoom=1.75&height=0.05&across=0.06&view=-14'
const AT_KNEE = '&zoom=2.2&height=-0.42&across=-0.12&view=-70'
const FIST = { width: 1300, height: 1300, crop: { left: 440, top: 540, width: 460, height: 420 } }
const NECK = { width: 900, height: 900, crop: { left: 270, top: 130, width: 450, height: 660 } }
const BASIC_EXPRESSIONS = ['neutral', 'happiness', 'surprise', 'anger', 'sadness', 'fear', 'disgust']

const POSES = [
  { browInnerUp: 1, ...both('browOuterUp'), ...both('eyeWide', 0.8), jawOpen: 0.25 },
  { ...both('browDown'), ...both('eyeSquint', 0.3), ...both('mouthPress', 0.4) },
  { ...both('mouthSmile', 0.9), ...both('cheekSquint', 0.8), ...both('eyeSquint', 0.3) },
  { ...both('noseSneer'), ...both('mouthUpperUp', 0.5), ...both('browDown', 0.4) },
  { ...both('eyeSquint'), ...both('cheekSquint') },
  { mouthPucker: 1 },
  { browOuterUpLeft: 1, browInnerUp: 0.2 },
  { mouthSmileRight: 1, cheekSquintRight: 0.8 },
]
/** Returns the pictures of a face: one row without wrinkles, then one row per age. */
const agesOf = (name, picture) =>
  [undefined, ...AGES].flatMap((age) =>
    POSES.map((targets, i) => ({
      ...picture,
      targets,
      face: `${name}${age ?? AGES[0]}`,
      mode: age === undefined ? 'off' : 'default',
      beginsRow: i === 0,
    })),
  )

const FLUSHED = { width: 760, height: 760, crop: { left: 250, top: 170, width: 260, height: 380 } }
const FLUSHES = [
  { ...both('mouthSmile', 0.9), ...both('cheekSquint', 0.8) },
  { ...both('noseSneer'), ...both('browDown', 0.8) },
]

/** Returns one row per skin colour. Each row shows each expression twice: without and with blood maps. */
const bloodOfSkins = () =>
  Object.keys(SKINS).flatMap((skin) =>
    FLUSHES.flatMap((targets, i) =>
      ['Pale', ''].map((end, k) => ({
        ...FLUSHED,
        targets,
        face: `${skin}${end}`,
        beginsRow: i === 0 && k === 0,
      })),
    ),
  )

/**
 * Pictures of each figure, row by row. `beginsRow` starts a row. A picture is a request to `renderPictures`, or names the
 * `page` of an example. Both kinds of pictures can have a crop and a scale. `face` names one of `FACES`. Default: faces/human.glb.
 */
export const FIGURES = {
  guide: ['neutral', 'happy'].map((expression) => ({ ...PORTRAIT, face: 'guide', expression, scale: 0.6 })),
  'figure-8': [
    { ...PORTRAIT, expression: 'neutral' },
    { ...PORTRAIT, expression: 'surprised' },
  ],
  'figure-9': [
    { ...PORTRAIT, expression: 'leftBrow' },
    { ...PORTRAIT, expression: 'rightBrow' },
  ],
  'figure-10': [
    { ...EYE, activations: { crowsFeetLeft: 1 }, targets: { cheekSquintLeft: 1, eyeSquintLeft: 0.6 } },
  ],
  ktx2: [
    { ...BROW, face: 'images' },
    { ...BROW, face: 'arrays' },
  ],
  muscles: BASIC_EXPRESSIONS.map((name) => ({ ...PAGE, page: `muscles.html?expression=${name}` })),
  joints: [
    { ...HAND, page: 'joints.html?fist=0' },
    { ...HAND, page: 'joints.html?fist=1&smooth' },
    { ...HAND, page: 'joints.html?fist=1' },
    { ...NECK, page: 'joints.html?model=neck&turn=1&smooth' },
    { ...NECK, page: 'joints.html?model=neck&turn=1' },
  ],
  body: ['&smooth', ''].flatMap((end, row) =>
    [
      { ...HAND, page: 'joints.html?fist=0' },
      { ...HAND, page: 'joints.html?fist=0.45' },
      { ...HAND, page: 'joints.html?fist=0&view=165' },
      { ...NECK, page: 'joints.html?model=neck&turn=0' },
      { ...NECK, page: 'joints.html?model=neck&turn=0.5' },
      { ...NECK, page: 'joints.html?model=neck&turn=1' },
      { ...NECK, page: 'joints.html?model=neck&nod=1' },
    ].map((picture, i) => ({
      ...picture,
      page: picture.page + end,
      scale: 0.6,
      beginsRow: row > 0 && i === 0,
    })),
  ),
  clothes: ['&smooth', ''].flatMap((end, row) =>
    [
      ...[0.2, 0.55, 1.4].map((time) => ({
        ...CLOTHES,
        page: `clothes.html?clip=reach&time=${time}${AT_ELBOW}`,
      })),
      ...[0.2, 0.65, 1.6].map((time) => ({
        ...CLOTHES,
        page: `clothes.html?clip=sit&time=${time}${AT_KNEE}`,
      })),
      ...['bend&time=1.5', 'turn&time=4.5'].map((clip) => ({
        ...CLOTHES,
        page: `clothes.html?clip=${clip}${AT_WAIST}`,
      })),
    ].map((picture, i) => ({
      ...picture,
      page: picture.page + end,
      scale: 0.6,
      beginsRow: row > 0 && i === 0,
    })),
  ),
  knuckles: [
    { ...FIST, page: 'joints.html?fist=1&view=165&smooth' },
    { ...FIST, page: 'joints.html?fist=1&view=165' },
  ],
  age: [20, 40, 60, 80].map((years) => ({ ...PAGE, page: `age.html?age=${years}` })),
  normals: ['none', 'baked', 'recomputed'].map((remedy) => ({
    ...CHEEKS,
    page: `normals.html?webgl&remedy=${remedy}&cheekPuff=1&mouthPucker=0.7`,
  })),
  inspector: ['shaded', 'influence', 'normals', 'strain'].map((view, i) => ({
    ...PANEL,
    page: `inspector.html?view=${view}`,
    beginsRow: i === 2,
  })),
  'auto-human': agesOf('human', {
    width: 630,
    height: 540,
    crop: { left: 157, top: 36, width: 315, height: 374 },
  }),
  'auto-scan': agesOf('scan', {
    mesh: 'face',
    width: 630,
    height: 540,
    crop: { left: 157, top: 8, width: 315, height: 374 },
  }),
  // Buttons of the studio's first page.
  'portraits/human': [STUDIO_PORTRAIT],
  'portraits/human-2': [{ ...STUDIO_PORTRAIT, face: 'human-2' }],
  blood: bloodOfSkins(),
  transform: [FOREHEAD, { ...FOREHEAD, face: 'lossless' }, { ...FOREHEAD, face: 'lossy' }],
  ...CLOSE_UPS,
  'skin/furrows': FURROWS,
  expressions: movingPictures(),
  'body-moving': movingBodyPictures(),
}

/** Animations: a function that returns the frames, by the name of the figure. */
export const MOVING = { expressions: movingFrames, 'body-moving': movingBodyFrames }

/** File format per figure. Default: PNG. Figures with many faces are smaller as JPEG. */
export const FORMATS = {
  ...Object.fromEntries(
    [
      'guide',
      'body',
      'clothes',
      'auto-human',
      'auto-scan',
      'portraits/human',
      'portraits/human-2',
      'blood',
      'inspector',
      'skin/furrows',
      ...Object.keys(CLOSE_UPS),
    ].map((name) => [name, 'jpg']),
  ),
  ...Object.fromEntries(Object.keys(MOVING).map((name) => [name, 'webp'])),
}
