/** Side that a shape moves, as the person has it. */
export type Side = 'left' | 'right' | 'both'

/** An ARKit shape without its side. */
export interface ShapeLabel {
  family: string
  side: Side
}

/** Shapes that ARKit has for either side. */
export const SIDED = [
  'browDown',
  'browOuterUp',
  'eyeBlink',
  'eyeSquint',
  'eyeWide',
  'eyeLookUp',
  'eyeLookDown',
  'eyeLookIn',
  'eyeLookOut',
  'cheekSquint',
  'noseSneer',
  'mouthSmile',
  'mouthFrown',
  'mouthDimple',
  'mouthStretch',
  'mouthPress',
  'mouthUpperUp',
  'mouthLowerDown',
] as const

/** Shapes that ARKit has for both sides at once; some rigs split them. */
export const CENTRAL = [
  'browInnerUp',
  'cheekPuff',
  'jawOpen',
  'jawForward',
  'mouthClose',
  'mouthFunnel',
  'mouthPucker',
  'mouthRollLower',
  'mouthRollUpper',
  'mouthShrugLower',
  'mouthShrugUpper',
] as const

/** Central shapes that rigs split. */
export const SPLIT: readonly string[] = ['browInnerUp', 'cheekPuff', 'mouthPucker', 'mouthFunnel']

/** Shapes that move the mouth to a side: the direction is part of their name. */
export const SHIFTED = ['jawLeft', 'mouthLeft'] as const

/** All names of shapes: ARKit's, those of sided shapes without their side, and halves of central ones. */
export const SHAPE_NAMES: readonly string[] = [
  ...SIDED.flatMap((name) => [name, ...halvesOf(name)]),
  ...CENTRAL.flatMap((name) => (SPLIT.includes(name) ? [name, ...halvesOf(name)] : [name])),
  ...SHIFTED.flatMap((name) => [name, name.replace('Left', 'Right')]),
  'tongueOut',
]

function halvesOf(name: string): [left: string, right: string] {
  return [`${name}Left`, `${name}Right`]
}

/** ARKit's name: a shape of both sides has its family's. */
export function arkitName({ family, side }: ShapeLabel): string {
  return side === 'both' ? family : family + (side === 'left' ? 'Left' : 'Right')
}

/** Parses ARKit's name; undefined for any other. */
export function labelOf(name: string): ShapeLabel | undefined {
  // A tongue is mostly a mesh of its own: its motion tells nothing.
  if (isOneOf(CENTRAL, name) || isOneOf(SIDED, name) || name === 'tongueOut')
    return { family: name, side: 'both' }
  const [, stem, end] = /^(.*?)(Left|Right)$/.exec(name) ?? []
  if (stem === undefined) return undefined
  if (isOneOf(SHIFTED, `${stem}Left`)) return { family: name, side: 'both' }
  const isKnown = isOneOf(SIDED, stem) || isOneOf(CENTRAL, stem)
  return isKnown ? { family: stem, side: end === 'Left' ? 'left' : 'right' } : undefined
}

/** The same on the other side of the face. */
export function mirroredLabel({ family, side }: ShapeLabel): ShapeLabel {
  if (isShifted(family))
    return { family: family.replace(/Left|Right/, (end) => (end === 'Left' ? 'Right' : 'Left')), side }
  return { family, side: side === 'both' ? side : side === 'left' ? 'right' : 'left' }
}

/** Whether ARKit has the shape for both sides at once. */
export function isCentral(family: string): boolean {
  return isOneOf(CENTRAL, family)
}

/** Whether ARKit has the shape for either side alone. */
export function isSided(family: string): boolean {
  return isOneOf(SIDED, family)
}

/** Whether the shape moves the mouth to a side. */
export function isShifted(family: string): boolean {
  return /^(jaw|mouth)(Left|Right)$/.test(family)
}

function isOneOf(names: readonly string[], name: string): boolean {
  return names.includes(name)
}
