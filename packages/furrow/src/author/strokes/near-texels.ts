import { quadraticForm } from '../../math/quadratic-form.ts'
import { clamp } from '../../math/scalar.ts'
import { type Metric, metricAt } from '../metric.ts'

/**
 * Is given a texel near a polyline.
 *
 * @param distance in millimetres.
 * @param side -1 to the left along the polyline as seen in the texture, 1 to the right, in between round its ends.
 * @param segment the nearest segment, by the number of its first point.
 * @param t of the nearest point, 0..1 along the segment.
 */
export type VisitTexel = (texel: number, distance: number, side: number, segment: number, t: number) => void

/** Enlarges the search region, for the metric varies between polyline and texel. */
const SLACK = 1.5

/**
 * Visits every texel within `reach` millimetres of a polyline once, with the nearest point of the polyline. Distances are
 * measured by the metric of the texel: exact where the texture is evenly stretched, and correct to first order elsewhere.
 *
 * @param points u and v of each point.
 */
export function visitTexelsNear(
  points: Float64Array,
  metric: Metric,
  reach: number,
  visit: VisitTexel,
): void {
  const { width, height } = metric
  const segments = points.length / 2 - 1
  const boxes = new Int32Array(4 * segments)
  const form = new Float64Array(3)
  let [left, top, right, bottom] = [width, height, -1, -1]
  for (let i = 0; i < segments; i++) {
    const [u0, v0, u1, v1] = [points[2 * i], points[2 * i + 1], points[2 * i + 2], points[2 * i + 3]]
    metricAt(metric, (u0 + u1) / 2, (v0 + v1) / 2, form)
    // Half extents of the ellipse of all steps that are `reach` long.
    const det = form[0] * form[2] - form[1] * form[1]
    const du = SLACK * reach * Math.sqrt(form[2] / det)
    const dv = SLACK * reach * Math.sqrt(form[0] / det)
    boxes[4 * i] = Math.max(Math.floor((Math.min(u0, u1) - du) * width), 0)
    boxes[4 * i + 1] = Math.max(Math.floor((Math.min(v0, v1) - dv) * height), 0)
    boxes[4 * i + 2] = Math.min(Math.ceil((Math.max(u0, u1) + du) * width), width - 1)
    boxes[4 * i + 3] = Math.min(Math.ceil((Math.max(v0, v1) + dv) * height), height - 1)
    left = Math.min(left, boxes[4 * i])
    top = Math.min(top, boxes[4 * i + 1])
    right = Math.max(right, boxes[4 * i + 2])
    bottom = Math.max(bottom, boxes[4 * i + 3])
  }
  if (right < left || bottom < top) return
  const columns = right - left + 1
  const cells = columns * (bottom - top + 1)
  const nearestSquared = new Float32Array(cells).fill(Number.POSITIVE_INFINITY)
  const nearestSegment = new Int32Array(cells)
  const nearestT = new Float32Array(cells)
  for (let i = 0; i < segments; i++) {
    const [u0, v0] = [points[2 * i], points[2 * i + 1]]
    const [du, dv] = [points[2 * i + 2] - u0, points[2 * i + 3] - v0]
    for (let y = boxes[4 * i + 1]; y <= boxes[4 * i + 3]; y++) {
      const qv = (y + 0.5) / height - v0
      for (let x = boxes[4 * i]; x <= boxes[4 * i + 2]; x++) {
        const qu = (x + 0.5) / width - u0
        const texel = y * width + x
        const uu = metric.uu[texel]
        const uv = metric.uv[texel]
        const vv = metric.vv[texel]
        const along = uu * du * qu + uv * (du * qv + dv * qu) + vv * dv * qv
        const length = quadraticForm(uu, uv, vv, du, dv)
        const t = along <= 0 || length === 0 ? 0 : along >= length ? 1 : along / length
        const squared = quadraticForm(uu, uv, vv, qu - t * du, qv - t * dv)
        const cell = (y - top) * columns + x - left
        if (squared < nearestSquared[cell]) {
          nearestSquared[cell] = squared
          nearestSegment[cell] = i
          nearestT[cell] = t
        }
      }
    }
  }
  for (let cell = 0; cell < cells; cell++) {
    const distance = Math.sqrt(Math.max(nearestSquared[cell], 0))
    if (distance >= reach) continue
    const x = left + (cell % columns)
    const y = top + Math.floor(cell / columns)
    const texel = y * width + x
    const segment = nearestSegment[cell]
    const side = sideOf(points, segment, (x + 0.5) / width, (y + 0.5) / height, metric, texel, distance)
    visit(texel, distance, side, segment, nearestT[cell])
  }
}

/** Signed distance from the segment's line over the distance from the segment: -1 or 1 beside it, 0 straight ahead of its ends. */
function sideOf(
  points: Float64Array,
  segment: number,
  u: number,
  v: number,
  metric: Metric,
  texel: number,
  distance: number,
): number {
  if (distance === 0) return 0
  const [u0, v0] = [points[2 * segment], points[2 * segment + 1]]
  const [du, dv] = [points[2 * segment + 2] - u0, points[2 * segment + 3] - v0]
  const [uu, uv, vv] = [metric.uu[texel], metric.uv[texel], metric.vv[texel]]
  const length = Math.sqrt(quadraticForm(uu, uv, vv, du, dv))
  if (length === 0) return 0
  // v points down, so a positive cross product is to the right.
  const fromLine = ((du * (v - v0) - dv * (u - u0)) * Math.sqrt(uu * vv - uv * uv)) / length
  return clamp(fromLine / distance, -1, 1)
}
