import { otherSide } from '../document/sides.ts'
import { poseOf, writePose } from '../viewer/pose/pose.ts'
import type { Viewer } from '../viewer/viewer.ts'

/** Expressions that show most wrinkles, in the order of the performance: surprise, frown and smile. */
const PREFERRED = ['surprised', 'angry', 'happy']
/** Number of expressions or poses that are performed if none is preferred. */
const COUNT = 3

export interface RevealPlan {
  readonly kind: 'expression' | 'pose'
  /** Names of the expressions or poses to perform. */
  readonly plan: readonly string[]
  /** The one among them that shows most wrinkles. */
  readonly strongest: string
}

/**
 * Returns the expressions that an avatar performs: surprise, frown and smile, or the three that show most wrinkles if it has none of these. If no
 * expression shows a wrinkle, returns the poses of joints that show most. Returns null if nothing shows a wrinkle.
 */
export function revealPlan(viewer: Viewer): RevealPlan | null {
  const before = poseOf(viewer)
  const { amounts, poses } = viewer.skeleton
  // The first expression is neutral.
  const [, ...expressions] = viewer.expressions
  try {
    return (
      planOf(
        'expression',
        strengthsOf(viewer, expressions, (name) => viewer.play(name, 0)),
      ) ??
      planOf(
        'pose',
        strengthsOf(viewer, poses, (name) => viewer.playPose(name, 0)),
      )
    )
  } finally {
    viewer.skeleton.amounts = amounts
    writePose(viewer, before)
  }
}

/** @param strengths sums of the activations that each expression or pose gives, in the order of the avatar. */
export function planOf(kind: RevealPlan['kind'], strengths: ReadonlyMap<string, number>): RevealPlan | null {
  const ranked = [...strengths].filter(([, sum]) => sum > 0).toSorted((a, b) => b[1] - a[1])
  if (ranked.length === 0) return null
  const names = ranked.map(([name]) => name)
  const preferred = PREFERRED.filter((name) => names.includes(name))
  const others = kind === 'pose' ? oneSideOf(names) : names
  const plan = preferred.length > 0 ? preferred : others.slice(0, COUNT)
  return { kind, plan, strongest: names.find((name) => plan.includes(name))! }
}

/** Leaves out poses whose counterpart on the other half of the body comes before them. */
function oneSideOf(names: readonly string[]): string[] {
  return names.filter((name, i) => !names.slice(0, i).includes(otherSide(name)))
}

/** Sums the activations of all areas for each expression or pose. Leaves the last one on the stage. */
function strengthsOf(
  { areas }: Viewer,
  shown: readonly { readonly name: string }[],
  show: (name: string) => void,
): ReadonlyMap<string, number> {
  return new Map(
    shown.map(({ name }) => {
      show(name)
      return [name, areas.reduce((sum, area) => sum + area.read(), 0)]
    }),
  )
}
