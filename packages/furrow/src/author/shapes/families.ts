/** Side of the face that a blendshape moves, from the person's view. */
export type Side = 'left' | 'right' | 'both'

/** Name of an ARKit shape, split into family and side. `mouthSmileLeft` has the family `mouthSmile` and the side `left`. */
export interface ShapeLabel {
  /** ARKit name without `Left` or `Right`. For names in `SHIFTED` and their mirror images, this is the complete name. */
  family: string
  side: Side
}

/** Families with two ARKit shapes, one for each side. */
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

/** Families with one ARKit shape for both sides. */
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

/** Families in `CENTRAL` that some rigs split into a left and a right shape. */
export const SPLIT: readonly string[] = ['browInnerUp', 'cheekPuff', 'mouthPucker', 'mouthFunnel']

/** Shapes that move jaw or mouth to the left; ARKit also has their mirror images. `Left` is a direction here, not a side of the face. */
export const SHIFTED = ['jawLeft', 'mouthLeft'] as const

/** Shape names to choose from: ARKit's names, families in `SIDED` without a side, and families in `SPLIT` with a side. */
export const SHAPE_NAMES: readonly string[] = [
  ...SIDED.flatMap((name) => [name, ...halvesOf(name)]),
  ...CENTRAL.flatMap((name) => (SPLIT.includes(name) ? [name, ...halvesOf(name)] : [name])),
  ...SHIFTED.flatMap((name) => [name, name.replace('Left', 'Right')]),
  'tongueOut',
]

function halvesOf(name: string): [left: string, right: string] {
  return [`${name}Left`, `${name}Right`]
}

/** Returns the name of a label: the family, followed by the side unless it is `both`. */
export function arkitName({ family, side }: ShapeLabel): string {
  return side === 'both' ? family : family + (side === 'left' ? 'Left' : 'Right')
}

/** Parses a name in `SHAPE_NAMES`, or any family in `CENTRAL` with a side, such as `jawOpenLeft`. Returns undefined for other names. */
export function labelOf(name: string): ShapeLabel | undefined {
  if (isOneOf(CENTRAL, name) || isOneOf(SIDED, name) || name === 'tongueOut')
    return { family: name, side: 'both' }
  const [, stem, end] = /^(.*?)(Left|Right)$/.exec(name) ?? []
  if (stem === undefined) return undefined
  if (isOneOf(SHIFTED, `${stem}Left`)) return { family: name, side: 'both' }
  const isKnown = isOneOf(SIDED, stem) || isOneOf(CENTRAL, stem)
  return isKnown ? { family: stem, side: end === 'Left' ? 'left' : 'right' } : undefined
}

export function mirroredLabel({ family, side }: ShapeLabel): ShapeLabel {
  if (isShifted(family))
    return { family: family.replace(/Left|Right/, (end) => (end === 'Left' ? 'Right' : 'Left')), side }
  return { family, side: side === 'both' ? side : side === 'left' ? 'right' : 'left' }
}

/** Returns whether ARKit has one shape of this family for both sides. */
export function isCentral(family: string): boolean {
  return isOneOf(CENTRAL, family)
}

/** Returns whether ARKit has a left and a right shape of this family. */
export function isSided(family: string): boolean {
  return isOneOf(SIDED, family)
}

/** Returns whether shapes of this family move the jaw or the mouth sideways. */
export function isShifted(family: string): boolean {
  return /^(jaw|mouth)(Left|Right)$/.test(family)
}

function isOneOf(names: readonly string[], name: string): boolean {
  return names.includes(name)
}
