import type { Metric } from '../metric.ts'
import type { Stroke } from './document.ts'
import { nearest } from './nearest.ts'
import { layOut, type Path } from './path.ts'
import { profile, REACH } from './profile.ts'

/** Relief of the skin. */
export interface HeightMap {
  width: number
  height: number
  /** Millimetres above (+) or below (-) the smooth skin, width x height values, row 0 is v = 0. */
  data: Float32Array
}

/**
 * Exponent with which strokes are joined: (a^6 + b^6)^(1/6) is the larger of two, rounded off where they are
 * alike (at most 12% more). Two valleys that cross are as deep as the deeper, not as both together.
 */
const JOIN = 6

/**
 * Draws strokes as a height map of the metric's size. Distances are measured on the skin, texel by texel.
 * Valleys are joined with valleys and banks with banks (see JOIN), then added, so the order of the strokes has
 * no influence and a single stroke keeps its exact profile. No valley's bottom is drawn sharper than a texel.
 * `progress` is told after every stroke how many are done.
 */
export function strokesToHeight(
  strokes: readonly Stroke[],
  metric: Metric,
  progress?: (done: number, total: number) => void,
): HeightMap {
  const { width, height } = metric
  const valley = new Float64Array(width * height)
  const bank = new Float64Array(width * height)
  strokes.forEach((stroke, i) => {
    draw(stroke, layOut(stroke, metric), metric, valley, bank)
    progress?.(i + 1, strokes.length)
  })
  const data = new Float32Array(width * height)
  for (let i = 0; i < data.length; i++) {
    if (valley[i] !== 0 || bank[i] !== 0) data[i] = bank[i] ** (1 / JOIN) - valley[i] ** (1 / JOIN)
  }
  return { width, height, data }
}

function draw(stroke: Stroke, path: Path, metric: Metric, valley: Float64Array, bank: Float64Array): void {
  const half = stroke.width / 2
  nearest(path.points, metric, REACH * half, (texel, distance, side, piece, share) => {
    const at = (values: Float64Array) => values[piece] + share * (values[piece + 1] - values[piece])
    const depth = stroke.depth * at(path.depth)
    if (depth === 0) return
    const reach = half * at(path.width)
    const texelSize = Math.sqrt(
      Math.max(metric.uu[texel] / metric.width ** 2, metric.vv[texel] / metric.height ** 2),
    )
    const softness = Math.max(stroke.softness, (0.5 * texelSize) / reach)
    const [left, right] = stroke.shoulder
    const shoulder = left + (right - left) * 0.5 * (1 + side)
    const h = depth * profile(distance / reach, shoulder, softness)
    if (h < 0) valley[texel] += (-h) ** JOIN
    else bank[texel] += h ** JOIN
  })
}
