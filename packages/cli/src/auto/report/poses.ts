import { findTargets } from 'furrow'
import type { AutoWrinkles } from 'furrow/author'

export interface Pose {
  name: string
  /** Weight per blendshape, 0..1. */
  targets: Record<string, number>
}

/**
 * Common expressions, with weights of ARKit blendshapes. A face supports an expression if it has all blendshapes that
 * have the weight 1 in the expression.
 */
const EXPRESSIONS: readonly Pose[] = [
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

/** Maximum number of poses for a face that supports none of the expressions. */
const MAX_POSES = 8

/**
 * Returns the expressions that a face supports. If there are none, returns the blendshapes that compress the skin most.
 */
export function posesOf({ targets, areas }: Pick<AutoWrinkles, 'targets' | 'areas'>): Pose[] {
  const expressions = EXPRESSIONS.flatMap(({ name, targets: wanted }): Pose[] => {
    const found = Object.entries(wanted).map(([shape, weight]) => {
      return { weight, names: findTargets(shape, targets).map((index) => targets[index]) }
    })
    if (found.some(({ weight, names }) => weight === 1 && names.length === 0)) return []
    const pairs = found.flatMap(({ weight, names }) => names.map((name) => [name, weight] as const))
    return [{ name, targets: Object.fromEntries(pairs) }]
  })
  if (expressions.length > 0) return expressions
  const strongest = [...areas].sort((a, b) => b.compression - a.compression)
  const causes = strongest.flatMap(({ driver }) => {
    const [first] = [...driver.targets].sort((a, b) => (b.weight ?? 1) - (a.weight ?? 1))
    return first ? [first.name] : []
  })
  return [...new Set(causes)].slice(0, MAX_POSES).map((name) => ({ name, targets: { [name]: 1 } }))
}
