import { expressionLabel } from './names.ts'

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
  onsetOf: 'Onset of',
  region: 'Region',
  allRegions: 'All regions, as activated',
  with: 'With wrinkles',
  without: 'Wrinkles off',
} as const

/** Camera views: their labels, and longer ones as tooltips. */
export const VIEW_NAMES = {
  front: { label: 'Front' },
  left: { label: 'Left' },
  right: { label: 'Right' },
  'three-quarter': { label: '3/4', title: 'Three quarter' },
  close: { label: 'Close-up' },
} as const

/** Explanations of what the stage can show. */
export const VIEW_HINTS = {
  shaded: 'The skin as in the file',
  clay: 'The shape alone',
  strain: 'How the current pose compresses and stretches the skin',
  normals: 'Directions of the surface',
  influence: 'Regions times their activations',
  onset: 'Activation at which the skin begins to wrinkle',
  wireframe: 'Edges of the triangles',
  strainColours: 'Orange is compressed, blue is stretched: full colours from 30% on.',
  onsetColours:
    'Orange begins to wrinkle early, blue late: full blue from activation 0.5 on. Dark has no delay.',
  noOnset: 'No layer has an onset map, so all lines begin at once.',
  light: 'Drag the light; Home or a double click resets it',
  still: 'Off, as the system asks for less motion',
} as const

/** Hints after the first avatar has opened. */
export const HINTS = {
  click: 'Click a wrinkle to select it.',
  drag: 'Drag across the line to deepen it, or move a slider of the card.',
  keys: 'Press 1 to 9, or a picture below, to see other expressions.',
} as const

/** Fields of the cards over the face. */
export const CARD = {
  strength: 'Strength',
  depth: 'Depth, mm',
  density: 'More or fewer lines',
  hide: 'Hide',
  section: 'Cross-section',
  shows: 'When does this wrinkle show?',
  always: 'Always',
  inPose: 'With this expression',
  noLines: 'This region has no lines.',
  fill: 'Fill with lines',
  notNow: 'Not now',
  noPose: 'To show it with an expression, press one first.',
} as const

/** Returns the label of the choice that shows a wrinkle with an expression: `With Surprised`. */
export function inExpression(name: string | null): string {
  return name === null ? CARD.inPose : `With ${expressionLabel(name)}`
}

/** Returns the direction of the light: `30° from the left, 20° from above`. @param yaw, pitch degrees; positive is right and up. */
export function lightLabel(yaw: number, pitch: number): string {
  const across = `${Math.abs(yaw)}° from the ${yaw < 0 ? 'left' : 'right'}`
  return `${across}, ${Math.abs(pitch)}° from ${pitch < 0 ? 'below' : 'above'}`
}
