import { useMemo } from 'preact/hooks'
import { splitSide } from '../../document/sides.ts'
import { framesOf, type TakeMotion, weightsOf } from '../../document/take.ts'
import { curvesLabel } from '../../labels/live.ts'
import { blendshapeLabel } from '../../labels/names.ts'

/** Number of blendshapes with curves, and points of a curve. */
const SHAPES = 4
const POINTS = 240

interface Curve {
  label: string
  /** Points of an SVG polyline: x is the fraction of the duration, y is 0 for the weight 1. */
  points: string
}

/** Curves of the blendshapes that move most in a take. */
export function Curves({ motion }: { motion: TakeMotion }) {
  const curves = useMemo(() => strongestCurves(motion), [motion])
  return (
    <svg
      class="curves"
      viewBox="0 0 1 1"
      preserveAspectRatio="none"
      role="img"
      aria-label={curvesLabel(curves.map(({ label }) => label))}
    >
      {curves.map(({ label, points }) => (
        <polyline key={label} points={points}>
          <title>{label}</title>
        </polyline>
      ))}
    </svg>
  )
}

function strongestCurves(motion: TakeMotion): Curve[] {
  const all = motion.names.map((name, i) => {
    const weights = weightsOf(motion, i)
    const [least, most] = weights.reduce(([low, high], w) => [Math.min(low, w), Math.max(high, w)], [1, 0])
    return { name, weights, extent: most - least }
  })
  // Both sides of an expression usually move alike, so the curve of the stronger side suffices.
  const sides = new Map(
    all.sort((a, b) => a.extent - b.extent).map((each) => [splitSide(each.name)[0], each]),
  )
  // The strongest one is last, so that it is drawn over the others.
  const strongest = [...sides.values()].sort((a, b) => a.extent - b.extent).slice(-SHAPES)
  return strongest.map(({ name, weights }) => ({
    label: blendshapeLabel(name),
    points: pointsOf(weights, framesOf(motion)),
  }))
}

/** Returns the highest weight of each interval, so that short motions stay visible. */
function pointsOf(weights: Float32Array, frames: number): string {
  const count = Math.min(POINTS, frames)
  const points = Array.from({ length: count }, (_, i) => {
    const [from, to] = [i, i + 1].map((index) => Math.floor((index * frames) / count))
    const most = weights.subarray(from, to).reduce((high, weight) => Math.max(high, weight), 0)
    return `${(i / (count - 1)).toFixed(4)},${(1 - most).toFixed(3)}`
  })
  return points.join(' ')
}
