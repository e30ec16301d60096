import { lerp } from '../../math/scalar.ts'
import type { Metric } from '../metric.ts'
import type { Stroke } from './document.ts'
import { visitTexelsNear } from './near-texels.ts'
import { layOutStroke } from './path.ts'
import { profile, REACH } from './profile.ts'

/** Relief of the skin. */
export interface HeightMap {
  width: number
  height: number
  /** Millimetres above (+) or below (-) the smooth skin, width x height values, row 0 is v = 0. */
  data: Float32Array
}

/**
 * Exponent of the smooth maximum that joins strokes: (a^6 + b^6)^(1/6) is the larger of two, at most 12% more where they are
 * equal. Valleys that cross are as deep as the deeper one, not as both together.
 */
const JOIN = 6

/**
 * Draws strokes as a height map of the metric's size. Distances are measured on the skin, texel by texel. Valleys are joined
 * with valleys and banks with banks (see JOIN), then added, so the order of the strokes does not matter and a single stroke
 * keeps its exact profile. No valley is drawn sharper than a texel.
 *
 * @param progress is called after each stroke.
 */
export function strokesToHeight(
  strokes: readonly Stroke[],
  metric: Metric,
  progress?: (done: number, total: number) => void,
): HeightMap {
  const { width, height } = metric
  const valleys = new Float64Array(width * height)
  const banks = new Float64Array(width * height)
  strokes.forEach((stroke, i) => {
    drawStroke(stroke, metric, valleys, banks)
    progress?.(i + 1, strokes.length)
  })
  const data = new Float32Array(width * height)
  for (let i = 0; i < data.length; i++) {
    if (valleys[i] !== 0 || banks[i] !== 0) data[i] = banks[i] ** (1 / JOIN) - valleys[i] ** (1 / JOIN)
  }
  return { width, height, data }
}

function drawStroke(stroke: Stroke, metric: Metric, valleys: Float64Array, banks: Float64Array): void {
  const path = layOutStroke(stroke, metric)
  const halfWidth = stroke.width / 2
  visitTexelsNear(path.points, metric, REACH * halfWidth, (texel, distance, side, segment, t) => {
    const depth = stroke.depth * lerp(path.depth[segment], path.depth[segment + 1], t)
    if (depth === 0) return
    const scale = halfWidth * lerp(path.width[segment], path.width[segment + 1], t)
    const texelSize = Math.sqrt(
      Math.max(metric.uu[texel] / metric.width ** 2, metric.vv[texel] / metric.height ** 2),
    )
    const softness = Math.max(stroke.softness, (0.5 * texelSize) / scale)
    const [left, right] = stroke.shoulder
    const shoulder = left + (right - left) * 0.5 * (1 + side)
    const h = depth * profile(distance / scale, shoulder, softness)
    if (h < 0) valleys[texel] += (-h) ** JOIN
    else banks[texel] += h ** JOIN
  })
}
