import { type Metric, metricAt } from '../metric.ts'

/**
 * What is told of a texel near a path: its index; the distance in millimetres; on which side it lies, -1 left
 * to 1 right of the way along the path as seen in the picture, in between round the ends; the piece of the path
 * that is nearest, and the share 0..1 along that piece.
 */
export type NearTexel = (texel: number, distance: number, side: number, piece: number, share: number) => void

/** How much farther than the metric at the path says texels are looked for: the metric varies across them. */
const SLACK = 1.5

/**
 * Visits every texel within `reach` millimetres of a path (u, v per point) once, with the nearest place of the
 * path. Distances are taken with the metric of the texel: exact where the texture is evenly stretched, and
 * right to first order elsewhere.
 */
export function nearest(points: Float64Array, metric: Metric, reach: number, visit: NearTexel): void {
  const { width, height } = metric
  const pieces = points.length / 2 - 1
  const boxes = new Int32Array(4 * pieces)
  const form = new Float64Array(3)
  let [left, top, right, bottom] = [width, height, -1, -1]
  for (let i = 0; i < pieces; i++) {
    const [u0, v0, u1, v1] = [points[2 * i], points[2 * i + 1], points[2 * i + 2], points[2 * i + 3]]
    metricAt(metric, (u0 + u1) / 2, (v0 + v1) / 2, form)
    // Extent of the ellipse of all steps that are `reach` long.
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
  const best = new Float32Array(cells).fill(Number.POSITIVE_INFINITY)
  const bestPiece = new Int32Array(cells)
  const bestShare = new Float32Array(cells)
  for (let i = 0; i < pieces; i++) {
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
        const length = uu * du * du + 2 * uv * du * dv + vv * dv * dv
        const share = along <= 0 || length === 0 ? 0 : along >= length ? 1 : along / length
        const [ru, rv] = [qu - share * du, qv - share * dv]
        const squared = uu * ru * ru + 2 * uv * ru * rv + vv * rv * rv
        const cell = (y - top) * columns + x - left
        if (squared < best[cell]) {
          best[cell] = squared
          bestPiece[cell] = i
          bestShare[cell] = share
        }
      }
    }
  }
  for (let cell = 0; cell < cells; cell++) {
    const distance = Math.sqrt(Math.max(best[cell], 0))
    if (distance >= reach) continue
    const x = left + (cell % columns)
    const y = top + Math.floor(cell / columns)
    const texel = y * width + x
    const i = bestPiece[cell]
    const side = sideOf(points, i, (x + 0.5) / width, (y + 0.5) / height, metric, texel, distance)
    visit(texel, distance, side, i, bestShare[cell])
  }
}

/** Distance from the piece's straight line over distance from the piece: -1, 1 beside it, 0 straight ahead. */
function sideOf(
  points: Float64Array,
  piece: number,
  u: number,
  v: number,
  metric: Metric,
  texel: number,
  distance: number,
): number {
  if (distance === 0) return 0
  const [u0, v0] = [points[2 * piece], points[2 * piece + 1]]
  const [du, dv] = [points[2 * piece + 2] - u0, points[2 * piece + 3] - v0]
  const [uu, uv, vv] = [metric.uu[texel], metric.uv[texel], metric.vv[texel]]
  const length = Math.sqrt(uu * du * du + 2 * uv * du * dv + vv * dv * dv)
  if (length === 0) return 0
  // v points down, so a positive cross product lies to the right of the way.
  const aside = ((du * (v - v0) - dv * (u - u0)) * Math.sqrt(uu * vv - uv * uv)) / length
  return Math.min(Math.max(aside / distance, -1), 1)
}
