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
} as const

/** Hints after the first avatar has opened. */
export const HINTS = {
  click: 'Click a wrinkle to select it.',
  drag: 'Drag across the line to deepen it, or move a slider of the card.',
  keys: 'Press 1 to 9 to see other expressions.',
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

/** Returns the label of the choice that shows a wrinkle with an expression: `With Surprised`. */
export function inExpression(name: string | null): string {
  return name === null ? CARD.inPose : `With ${expressionLabel(name)}`
}
