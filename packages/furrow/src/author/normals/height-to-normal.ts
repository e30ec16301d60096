import type { Bounds } from '../../core/bounds.ts'
import { FurrowError } from '../../core/error.ts'
import { toByte } from '../../core/normals/normal-byte.ts'
import type { RgbaImage } from '../../core/types.ts'
import { length3 } from '../../math/vector.ts'
import type { Metric } from '../metric.ts'
import type { HeightMap } from '../strokes/height.ts'
import { SLOPE_REACH, slopeAt } from './slope.ts'

/**
 * Tangent frame in which a renderer reads a normal map.
 *
 * - `orthonormal`: frame of MikkTSpace, for meshes with tangents. It consists of a unit tangent along +u and a perpendicular unit bitangent.
 * - `derivative`: frame of three.js for meshes without tangents. It consists of the gradients of u and v on the surface, both divided by the
 *   length of the longer one (Schueler, Normal Mapping Without Precomputed Tangents, ShaderX 5, 2006). The frame follows the deformed
 *   surface, so creases stay sharp where an expression shears the skin.
 *
 * Both frames are equal where the texture is neither stretched nor sheared.
 */
export type TangentFrame = 'orthonormal' | 'derivative'

/**
 * Converts heights to a tangent-space normal map. Components n of the normal are stored as linear bytes, `round((n + 1) * 127.5)`. Green
 * points towards smaller v as in glTF; alpha is 255.
 *
 * Slopes are heights per distance on the skin: the metric converts UV steps to distances (do Carmo, Differential Geometry of Curves and
 * Surfaces, 2.5, exercise 14). `slopeAt` flattens short waves: a wave of 8 texels keeps 95% of its slope, and a wave of 16 texels keeps 99.8%.
 *
 * @throws FurrowError if height map and metric differ in size.
 */
export function heightToNormal(
  heights: HeightMap,
  metric: Metric,
  frame: TangentFrame = 'orthonormal',
): RgbaImage {
  return turnedNormals(heights, metric, frame)
}

/**
 * Converts heights like `heightToNormal`, but lets the caller change the slopes.
 *
 * @param turn called with the two slopes of a texel, which it may change in place: first the slope stored in red, then the slope stored in
 *   green. Texels where both slopes are 0 are skipped.
 */
export function turnedNormals(
  heights: HeightMap,
  metric: Metric,
  frame: TangentFrame,
  turn?: (texel: number, slope: Float64Array) => void,
): RgbaImage {
  const { width, height } = heights
  if (metric.width !== width || metric.height !== height) {
    throw new FurrowError({
      who: 'heightToNormal',
      problem: 'height map and metric differ in size',
      value: `${width} x ${height}`,
      limit: `${metric.width} x ${metric.height}, the size of the metric`,
      remedy: 'measure the metric at the size of the height map',
    })
  }
  const normal = { width, height, data: new Uint8Array(4 * width * height) }
  drawNormals(normal, { x0: 0, y0: 0, x1: width, y1: height }, heights, metric, frame, turn)
  return normal
}

/** Redraws a rectangle of a normal map that `turnedNormals` returned. The map is changed in place. All maps must have the same size. */
export function drawNormals(
  { data }: RgbaImage,
  { x0, y0, x1, y1 }: Readonly<Bounds>,
  heights: HeightMap,
  metric: Metric,
  frame: TangentFrame,
  turn?: (texel: number, slope: Float64Array) => void,
): void {
  const { width, height } = heights
  const flat = toByte(0)
  const slope = new Float64Array(2)
  for (let y = y0; y < y1; y++) {
    for (let i = y * width + x0; i < y * width + x1; i++) {
      data[4 * i] = flat
      data[4 * i + 1] = flat
      data[4 * i + 2] = 255
      data[4 * i + 3] = 255
    }
  }
  // Skip texels without heights nearby, because most skin has no wrinkles.
  const sloping = slopingTexels(heights, { x0, y0, x1, y1 })
  for (let y = y0; y < y1; y++) {
    for (let x = sloping[2 * (y - y0)]; x < sloping[2 * (y - y0) + 1]; x++) {
      const i = y * width + x
      const hu = slopeAt(heights.data, y * width, x, 1, width, 'clamp') * width
      const hv = slopeAt(heights.data, x, y, width, height, 'clamp') * height
      if (hu === 0 && hv === 0) continue
      const uu = metric.uu[i]
      const uv = metric.uv[i]
      const vv = metric.vv[i]
      const det = uu * vv - uv * uv
      if (frame === 'derivative') {
        // The gradient is `hu * grad(u) + hv * grad(v)`, with `|grad(u)|^2 = vv / det` and `|grad(v)|^2 = uu / det`.
        const longer = Math.sqrt(Math.max(uu, vv) / det)
        slope[0] = -longer * hu
        slope[1] = longer * hv
      } else {
        // A unit step of v moves `sqrt(det / uu)` perpendicular to u, and `uv / sqrt(uu)` along u. Subtract the height gained along u.
        slope[0] = -hu / Math.sqrt(uu)
        slope[1] = (hv - (uv / uu) * hu) * Math.sqrt(uu / det)
      }
      turn?.(i, slope)
      const z = 1 / length3(slope[0], slope[1], 1)
      data[4 * i] = toByte(slope[0] * z)
      data[4 * i + 1] = toByte(slope[1] * z)
      data[4 * i + 2] = toByte(z)
      data[4 * i + 3] = 255
    }
  }
}

/** Returns, for each row, the range of texels near nonzero heights, as first column and last column plus 1. Other texels have no slope. */
function slopingTexels({ width, height, data }: HeightMap, { x0, y0, x1, y1 }: Readonly<Bounds>): Int32Array {
  const sloping = new Int32Array(2 * (y1 - y0))
  for (let row = 0; row < y1 - y0; row++) sloping[2 * row] = x1
  const left = Math.max(x0 - SLOPE_REACH, 0)
  const right = Math.min(x1 + SLOPE_REACH, width)
  for (let y = Math.max(y0 - SLOPE_REACH, 0); y < Math.min(y1 + SLOPE_REACH, height); y++) {
    let [first, end] = [left, right]
    while (first < end && data[y * width + first] === 0) first++
    while (first < end && data[y * width + end - 1] === 0) end--
    if (first === end) continue
    for (let near = Math.max(y - SLOPE_REACH, y0); near < Math.min(y + SLOPE_REACH + 1, y1); near++) {
      const i = 2 * (near - y0)
      sloping[i] = Math.min(sloping[i], Math.max(first - SLOPE_REACH, x0))
      sloping[i + 1] = Math.max(sloping[i + 1], Math.min(end + SLOPE_REACH, x1))
    }
  }
  return sloping
}
