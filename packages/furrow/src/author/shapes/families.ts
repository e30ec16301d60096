/** Side that a shape moves, from the person's view. */
export type Side = 'left' | 'right' | 'both'

/** ARKit shape without its side. */
export interface ShapeLabel {
  family: string
  side: Side
}

/** ARKit shapes that exist per side. */
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

/** ARKit shapes that move both sides at once; some rigs split them. */
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

/** Shapes that move the mouth sideways; the direction is part of their name. */
export const SHIFTED = ['jawLeft', 'mouthLeft'] as const

/** All shape names: ARKit's, sided shapes without their side, and halves of central shapes. */
export const SHAPE_NAMES: readonly string[] = [
  ...SIDED.flatMap((name) => [name, ...halvesOf(name)]),
  ...CENTRAL.flatMap((name) => (SPLIT.includes(name) ? [name, ...halvesOf(name)] : [name])),
  ...SHIFTED.flatMap((name) => [name, name.replace('Left', 'Right')]),
  'tongueOut',
]

function halvesOf(name: string): [left: string, right: string] {
  return [`${name}Left`, `${name}Right`]
}

/** Returns the ARKit name; a shape of both sides is named after its family. */
export function arkitName({ family, side }: ShapeLabel): string {
  return side === 'both' ? family : family + (side === 'left' ? 'Left' : 'Right')
}

/** Parses an ARKit name; undefined if it is not one. */
export function labelOf(name: string): ShapeLabel | undefined {
  // Tongues are mostly separate meshes, so motion cannot identify them; their name can.
  if (isOneOf(CENTRAL, name) || isOneOf(SIDED, name) || name === 'tongueOut')
    return { family: name, side: 'both' }
  const [, stem, end] = /^(.*?)(Left|Right)$/.exec(name) ?? []
  if (stem === undefined) return undefined
  if (isOneOf(SHIFTED, `${stem}Left`)) return { family: name, side: 'both' }
  const isKnown = isOneOf(SIDED, stem) || isOneOf(CENTRAL, stem)
  return isKnown ? { family: stem, side: end === 'Left' ? 'left' : 'right' } : undefined
}

/** Returns the label on the other side of the face. */
export function mirroredLabel({ family, side }: ShapeLabel): ShapeLabel {
  if (isShifted(family))
    return { family: family.replace(/Left|Right/, (end) => (end === 'Left' ? 'Right' : 'Left')), side }
  return { family, side: side === 'both' ? side : side === 'left' ? 'right' : 'left' }
}

/** Returns whether the ARKit shape moves both sides at once. */
export function isCentral(family: string): boolean {
  return isOneOf(CENTRAL, family)
}

/** Returns whether the ARKit shape exists per side. */
export function isSided(family: string): boolean {
  return isOneOf(SIDED, family)
}

/** Returns whether the shape moves the mouth sideways. */
export function isShifted(family: string): boolean {
  return /^(jaw|mouth)(Left|Right)$/.test(family)
}

function isOneOf(names: readonly string[], name: string): boolean {
  return names.includes(name)
}
