import { poseOf, writePose } from '../viewer/pose/pose.ts'
import type { Viewer } from '../viewer/viewer.ts'

/** Expressions that show most wrinkles, in the order of the performance: surprise, frown and smile. */
const PREFERRED = ['surprised', 'angry', 'happy']

export interface RevealPlan {
  /** Names of the expressions to perform. */
  readonly plan: readonly string[]
  /** The one among them that shows most wrinkles. */
  readonly strongest: string
}

/**
 * Returns the expressions that an avatar performs: surprise, frown and smile, or the three that show most wrinkles if it has none of these.
 * Returns null if no expression shows a wrinkle.
 */
export function revealPlan(viewer: Viewer): RevealPlan | null {
  return planOf(strengthsOf(viewer))
}

/** @param strengths sums of the activations that each expression gives, in the order of the expressions. */
export function planOf(strengths: ReadonlyMap<string, number>): RevealPlan | null {
  const ranked = [...strengths].filter(([, sum]) => sum > 0).toSorted((a, b) => b[1] - a[1])
  if (ranked.length === 0) return null
  const names = ranked.map(([name]) => name)
  const preferred = PREFERRED.filter((name) => names.includes(name))
  const plan = preferred.length > 0 ? preferred : names.slice(0, PREFERRED.length)
  return { plan, strongest: names.find((name) => plan.includes(name))! }
}

/** Sums the activations of all areas for each expression except the neutral first one. Restores the pose. */
function strengthsOf(viewer: Viewer): ReadonlyMap<string, number> {
  const before = poseOf(viewer)
  try {
    return new Map(
      viewer.expressions.slice(1).map(({ name }) => {
        viewer.play(name, 0)
        return [name, viewer.areas.reduce((sum, area) => sum + area.read(), 0)]
      }),
    )
  } finally {
    writePose(viewer, before)
  }
}
