import { quadraticForm } from '../../math/quadratic-form.ts'
import { type Metric, metricAt } from '../metric.ts'

/** Factor on the search distance, because the search uses the metric (millimetres per UV step) at the polyline instead of at the texels. */
const SLACK = 1.5

/**
 * Visits every texel within `reach` millimetres of a UV polyline once, with its distance in millimetres.
 * Distances are computed with the metric at the texel. They are exact where the metric is constant, and approximate elsewhere.
 *
 * @param points packed uv.
 */
export function visitTexelsNear(
  points: Float64Array,
  metric: Metric,
  reach: number,
  visit: (texel: number, distance: number) => void,
): void {
  const { width, height } = metric
  const segments = points.length / 2 - 1
  const boxes = new Int32Array(4 * segments)
  const form = new Float64Array(3)
  let [left, top, right, bottom] = [width, height, -1, -1]
  for (let i = 0; i < segments; i++) {
    const [u0, v0, u1, v1] = [points[2 * i], points[2 * i + 1], points[2 * i + 2], points[2 * i + 3]]
    metricAt(metric, (u0 + u1) / 2, (v0 + v1) / 2, form)
    // Points at the distance `reach` form an ellipse in UV space. Compute half its width and height.
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
        nearestSquared[cell] = Math.min(nearestSquared[cell], squared)
      }
    }
  }
  for (let cell = 0; cell < cells; cell++) {
    const distance = Math.sqrt(Math.max(nearestSquared[cell], 0))
    if (distance >= reach) continue
    visit((top + Math.floor(cell / columns)) * width + left + (cell % columns), distance)
  }
}
