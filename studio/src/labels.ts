/** All labels of the studio: names of tools, fields, buttons and parts of the face. Everyday words, beside which the page shows the file's names. */

import { displayName } from './display-name.ts'

export const MODES = {
  look: 'Look',
  lines: 'Lines',
  paint: 'Paint',
  motion: 'Motion',
} as const

export const TOOLS = {
  select: 'Select',
  draw: 'Draw a wrinkle',
  bend: 'Bend',
  smooth: 'Smooth',
  erase: 'Erase',
  paint: 'Paint',
  polygon: 'Polygon',
  mirror: 'Mirror',
} as const

export const PLACES = {
  inspector: 'Selection',
  expressions: 'Expressions',
  sliders: 'Sliders',
  targets: 'Blendshapes',
  shapes: 'Shapes',
  layers: 'Layers',
  drivers: 'Drivers',
  animation: 'Animation',
  brush: 'Brush',
  wholeFace: 'Whole face',
  newLine: 'New wrinkle',
  look: 'Look',
  when: 'When',
  maps: 'Maps',
  meshes: 'Meshes',
  regions: 'Regions',
  advanced: 'Advanced',
} as const

export const FILE = {
  project: 'Project',
  open: 'Open…',
  openFolder: 'Open folder…',
  openCapture: 'Open a recording…',
  face: 'Example face',
  recent: 'Recent work',
  edit: 'Edit wrinkles',
  undo: 'Undo',
  redo: 'Redo',
  share: 'Share',
  copyLink: 'Copy link',
  screenshot: 'Save picture',
  export: 'Export',
  exported: 'Exported file',
  ktx2: 'Compress for the GPU (KTX 2)',
  copyCode: 'Copy the code',
  code: 'Code that loads the file',
  saveProject: 'Save project (.zip)',
  preferences: 'Preferences',
  shortcuts: 'Shortcuts',
  close: 'Close',
} as const

/** Card on the empty stage. */
export const START = {
  drop: 'Drop your avatar',
  kinds: 'A .glb, .gltf or .vrm, alone or with its folder. It stays on this computer.',
  faces: 'Or begin with a face',
} as const

/** Hints after the first avatar has opened. */
export const HINTS = {
  click: 'Click a wrinkle to select it.',
  drag: 'Drag across the line to deepen it, or move a slider of the card.',
  keys: 'Press 1 to 9 to see other expressions.',
} as const

export const PREFERENCES = {
  renderer: 'Renderer',
  wrinkles: 'Wrinkles',
  page: 'Theme',
  statistics: 'Statistics',
} as const

export const VIEW = {
  show: 'Show',
  more: 'More views',
  light: 'Light',
  turntable: 'Turntable',
  shaded: 'Shaded',
  clay: 'Relief',
  strain: 'Strain',
  normals: 'Normals',
  influence: 'Regions',
  onset: 'Onset',
  wireframe: 'Wires',
} as const

/** Fields of automatic wrinkles. */
export const AUTOMATIC = {
  age: 'Age',
  strength: 'Strength',
  symmetry: 'Symmetry',
  size: 'Map size',
  shuffle: 'Shuffle',
  regions: 'Regions with wrinkles',
  savePreset: 'Save preset…',
  applyPreset: 'Apply preset…',
} as const

/** Fields and commands of a region, which the file calls an area. */
export const REGION = {
  name: 'Name in the file',
  layer: 'Layer',
  overlap: 'Overlap',
  rest: 'Always visible',
  record: 'This pose fully shows this region',
  duplicate: 'Duplicate',
  mirror: 'Copy to the other side',
  fromImage: 'From image…',
  remove: 'Delete',
  add: 'New region',
  addImage: 'Add from image…',
  paper: 'White = no wrinkles',
  reset: 'Reset',
} as const

/** Fields and commands of a wrinkle line. */
export const LINE = {
  line: 'Line',
  points: 'Points',
  width: 'Width, mm',
  depth: 'Depth, mm',
  softness: 'Softness',
  shoulder: 'Bulge',
  bank: 'Bulge width, mm',
  lean: 'Overhang',
  taper: 'Fading ends',
  reach: 'Reach, mm',
  group: 'Region',
  layer: 'Layer',
  smooth: 'Smooth',
  split: 'Split',
  mirror: 'Copy to the other side',
  detach: 'Detach',
  remove: 'Delete line',
  removeLines: 'Delete lines',
  chooseGroup: 'All of the region',
  removePoint: 'Delete point',
} as const

/** Headings and texts of the tab that tells when a region shows. */
export const WHEN = {
  expressions: 'Expressions that show it',
  noExpression: 'No expression of this avatar shows it.',
  strongest: 'Strongest drivers',
  noDriver: 'No driver shows it, only its slider.',
} as const

/** Fields of the cards over the face. */
export const CARD = {
  strength: 'Strength',
  depth: 'Depth, mm',
  density: 'Line count',
  hide: 'Hide',
  section: 'Cross-section',
  shows: 'When does this wrinkle show?',
  always: 'Always',
  inPose: 'With this expression',
  noPose: 'To show it with an expression, press one first.',
} as const

/** Everyday names of the regions, by their names in files without the side. */
const REGION_NAMES: Readonly<Record<string, string>> = {
  brow: 'Brow',
  forehead: 'Forehead',
  foreheadInner: 'Inner forehead',
  foreheadOuter: 'Outer forehead',
  glabella: 'Between the brows',
  noseRoot: 'Bridge of the nose',
  nose: 'Nose',
  crowsFeet: 'Crow’s feet',
  underEye: 'Under the eye',
  nasolabial: 'Smile line',
  mouthCorner: 'Corner of the mouth',
  upperLip: 'Upper lip',
  lowerLip: 'Lower lip',
  chin: 'Chin',
  neck: 'Neck',
  bag: 'Bag under the eye',
  hood: 'Upper eyelid',
  cheek: 'Cheek',
  jowl: 'Jowl',
  paleLips: 'Pale lips',
}

/** Everyday names of ARKit's blendshapes, by their names without the side. */
const BLENDSHAPE_NAMES: Readonly<Record<string, string>> = {
  browDown: 'Brow lowered',
  browInnerUp: 'Inner brows raised',
  browOuterUp: 'Outer brow raised',
  cheekPuff: 'Cheeks puffed',
  cheekSquint: 'Cheek raised',
  eyeBlink: 'Eye closed',
  eyeLookDown: 'Eye looks down',
  eyeLookIn: 'Eye looks inwards',
  eyeLookOut: 'Eye looks outwards',
  eyeLookUp: 'Eye looks up',
  eyeSquint: 'Eye squinted',
  eyeWide: 'Eye wide open',
  jawForward: 'Jaw forward',
  jawLeft: 'Jaw to the left',
  jawOpen: 'Jaw open',
  jawRight: 'Jaw to the right',
  mouthClose: 'Lips closed',
  mouthDimple: 'Mouth corner pulled back',
  mouthFrown: 'Mouth corner lowered',
  mouthFunnel: 'Lips funnelled',
  mouthLeft: 'Mouth to the left',
  mouthLowerDown: 'Lower lip lowered',
  mouthPress: 'Lips pressed',
  mouthPucker: 'Lips puckered',
  mouthRight: 'Mouth to the right',
  mouthRollLower: 'Lower lip rolled in',
  mouthRollUpper: 'Upper lip rolled in',
  mouthShrugLower: 'Chin raised',
  mouthShrugUpper: 'Upper lip pushed up',
  mouthSmile: 'Smile',
  mouthStretch: 'Mouth stretched',
  mouthUpperUp: 'Upper lip raised',
  noseSneer: 'Nose wrinkled',
  tongueOut: 'Tongue out',
}

/** Splits a region's name into the name without its side, and the side. */
function splitSide(name: string): [stem: string, side: string] {
  const side = name.match(/(?<=.)(Left|Right)$/)?.[0] ?? ''
  return [name.slice(0, name.length - side.length), side]
}

/** Returns the label of the choice that shows a wrinkle with an expression: `With Surprised`. */
export function inExpression(name: string | null): string {
  return name === null ? CARD.inPose : `With ${expressionLabel(name)}`
}

/** Returns the label of problems with drivers: `1 problem`. */
export function problemsLabel(count: number): string {
  return count === 1 ? '1 problem' : `${count} problems`
}

/** Returns the label of several chosen lines: `3 lines`. */
export function linesLabel(count: number): string {
  return `${count} lines`
}

/** Returns the label of a joint, a muscle or a number: `Left arm` for `leftArm`. */
export function nameLabel(name: string): string {
  return displayName(name)
}

/** Returns the label of an expression: `Left brow` for `leftBrow`. */
export function expressionLabel(name: string): string {
  return displayName(name)
}

/** Returns the everyday name of a blendshape: `Brow lowered, left` for `browDownLeft`. */
export function blendshapeLabel(name: string): string {
  const [stem, side] = splitSide(name)
  if (BLENDSHAPE_NAMES[name]) return BLENDSHAPE_NAMES[name]
  return BLENDSHAPE_NAMES[stem] ? `${BLENDSHAPE_NAMES[stem]}, ${side.toLowerCase()}` : displayName(name)
}

/** Returns the everyday name of a region without its side: `Inner forehead` for `foreheadInner`. */
export function regionName(stem: string): string {
  if (REGION_NAMES[stem]) return REGION_NAMES[stem]
  const flushed = stem.match(/^flush(.+)$/)?.[1]
  return flushed ? `Redness: ${regionName(lowered(flushed)).toLowerCase()}` : displayName(stem)
}

/** Returns the everyday name of a region: `Inner forehead, left` for `foreheadInnerLeft`. */
export function regionLabel(name: string): string {
  const [stem, side] = splitSide(name)
  return side ? `${regionName(stem)}, ${side.toLowerCase()}` : regionName(name)
}

function lowered(name: string): string {
  return name[0].toLowerCase() + name.slice(1)
}
