import { findTargets } from 'furrow'
import type { AutoWrinkles } from 'furrow/author'

/** A pose that the report shows. */
export interface ShownPose {
  name: string
  /** Weights 0..1 by target, as the face has them. */
  targets: Record<string, number>
}

/** What faces do most; a face that lacks a shape of weight 1 does not show the expression, the others are thrown in where it has them. */
const EXPRESSIONS: readonly ShownPose[] = [
  {
    name: 'Surprise',
    targets: {
      browInnerUp: 1,
      browOuterUpLeft: 1,
      browOuterUpRight: 1,
      eyeWideLeft: 0.6,
      eyeWideRight: 0.6,
      jawOpen: 0.2,
    },
  },
  {
    name: 'Frown',
    targets: { browDownLeft: 1, browDownRight: 1, mouthFrownLeft: 0.4, mouthFrownRight: 0.4 },
  },
  {
    name: 'Smile',
    targets: { mouthSmileLeft: 1, mouthSmileRight: 1, cheekSquintLeft: 0.8, cheekSquintRight: 0.8 },
  },
  {
    name: 'Sneer',
    targets: { noseSneerLeft: 1, noseSneerRight: 1, mouthUpperUpLeft: 0.5, mouthUpperUpRight: 0.5 },
  },
  {
    name: 'Squint',
    targets: { eyeSquintLeft: 1, eyeSquintRight: 1, cheekSquintLeft: 0.9, cheekSquintRight: 0.9 },
  },
  { name: 'Pucker', targets: { mouthPucker: 1 } },
  { name: 'Left brow alone', targets: { browOuterUpLeft: 1, browInnerUpLeft: 0.8 } },
  { name: 'Right side of the smile alone', targets: { mouthSmileRight: 1, cheekSquintRight: 0.8 } },
]

/** Poses that are shown of a skin without any expression. */
const MOST = 8

/** The expressions that a face can make; of a skin that can make none, what creases it most. */
export function posesOf({ targets, areas }: Pick<AutoWrinkles, 'targets' | 'areas'>): ShownPose[] {
  const expressions = EXPRESSIONS.flatMap(({ name, targets: asked }): ShownPose[] => {
    const found = Object.entries(asked).map(([shape, weight]) => {
      return { weight, names: findTargets(shape, targets).map((index) => targets[index]) }
    })
    if (found.some(({ weight, names }) => weight === 1 && names.length === 0)) return []
    const pairs = found.flatMap(({ weight, names }) => names.map((own) => [own, weight] as const))
    return [{ name, targets: Object.fromEntries(pairs) }]
  })
  if (expressions.length > 0) return expressions
  const strongest = [...areas].sort((a, b) => b.compression - a.compression)
  const causes = strongest.flatMap(({ driver }) => {
    const [first] = [...driver.targets].sort((a, b) => (b.weight ?? 1) - (a.weight ?? 1))
    return first ? [first.name] : []
  })
  return [...new Set(causes)].slice(0, MOST).map((name) => ({ name, targets: { [name]: 1 } }))
}
