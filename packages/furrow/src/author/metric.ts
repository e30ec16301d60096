import { FurrowError } from '../core/error.ts'
import { MAX_IMAGE_SIDE } from '../core/limits.ts'
import { interpolate } from '../math/barycentrics.ts'
import { clamp } from '../math/scalar.ts'
import { copyNearest } from './border.ts'
import { coverTexels } from './cover-texels.ts'

/** Mesh to measure. Its arrays are not changed, and only `skinCanvas` keeps some of them. */
export interface MetricMesh {
  /** Packed xyz per vertex, in metres unless a function says otherwise. */
  positions: ArrayLike<number>
  /** Packed uv per vertex, v = 0 at the top. */
  uvs: ArrayLike<number>
  /** Three vertices per triangle. Default: every three vertices form a triangle. */
  indices?: ArrayLike<number>
}

/**
 * Scale of a texture on the skin: at each texel, the first fundamental form of the surface P(u, v) (do Carmo, Differential Geometry of
 * Curves and Surfaces, 2.5). A small step (du, dv) in the texture is `sqrt(uu * du^2 + 2 * uv * du * dv + vv * dv^2)` millimetres long on
 * the skin. All maps have `width * height` values; row 0 is at v = 0.
 */
export interface Metric {
  width: number
  height: number
  /** `dot(dP/du, dP/du)` in mm^2. */
  uu: Float32Array
  /** `dot(dP/du, dP/dv)` in mm^2. */
  uv: Float32Array
  /** `dot(dP/dv, dP/dv)` in mm^2. */
  vv: Float32Array
  /** 1 where a triangle covers the texel's centre, 0 where the values are copied from the nearest covered texel. */
  inside: Uint8Array
}

/** Millimetres per metre. Positions in glTF are in metres. */
export const MILLIMETRES_PER_METRE = 1000

/** Minimum squared sine of the angle between dP/du and dP/dv. It keeps distances finite on degenerate triangles. */
const MIN_SQUARED_SINE = 1e-4

/**
 * Computes the metric of a mesh. Each vertex gets the area-weighted mean metric of its triangles. The means are interpolated across triangles,
 * so that facets do not show. Texels outside the UV islands copy the nearest covered texel. Where triangles overlap, the last triangle wins.
 *
 * @param width map width in texels; also the default height.
 * @param scale millimetres per unit of the positions.
 * @throws FurrowError if no triangle covers a texel, or the arrays are inconsistent.
 */
export function surfaceMetric(
  mesh: MetricMesh,
  width: number,
  height = width,
  scale = MILLIMETRES_PER_METRE,
): Metric {
  checkSize(width)
  checkSize(height)
  checkMesh(mesh)
  const texels = width * height
  const metric: Metric = {
    width,
    height,
    uu: new Float32Array(texels),
    uv: new Float32Array(texels),
    vv: new Float32Array(texels),
    inside: new Uint8Array(texels),
  }
  const forms = vertexForms(mesh, scale)
  // The last triangle that covers a texel wins, so triangles are drawn in reverse order, and each texel keeps its first value.
  const triangles = Math.floor(cornerCount(mesh) / 3)
  for (let t = triangles - 1; t >= 0; t--) rasterizeForms(metric, mesh, forms, 3 * t)
  if (!metric.inside.includes(1)) {
    throw new FurrowError({
      who: 'surfaceMetric',
      problem: 'no triangle of the mesh covers a texel of the map',
      limit: 'texture coordinates within 0..1 and triangles with area',
      remedy: 'check that the mesh is unwrapped',
    })
  }
  copyNearest(metric.inside, width, [metric.uu, metric.uv, metric.vv])
  return metric
}

/**
 * Samples the metric bilinearly, clamped at the border.
 *
 * @param form receives uu, uv and vv.
 */
export function metricAt(metric: Metric, u: number, v: number, form: Float64Array): void {
  const { width, height } = metric
  const x = clamp(u * width - 0.5, 0, width - 1)
  const y = clamp(v * height - 0.5, 0, height - 1)
  const x0 = Math.floor(x)
  const y0 = Math.floor(y)
  const right = Math.min(x0 + 1, width - 1) - x0
  const upper = y0 * width + x0
  const lower = Math.min(y0 + 1, height - 1) * width + x0
  const fx = x - x0
  const fy = y - y0
  const sample = (map: Float32Array) =>
    (1 - fy) * ((1 - fx) * map[upper] + fx * map[upper + right]) +
    fy * ((1 - fx) * map[lower] + fx * map[lower + right])
  form[0] = sample(metric.uu)
  form[1] = sample(metric.uv)
  form[2] = sample(metric.vv)
}

function cornerCount({ indices, positions }: MetricMesh): number {
  return indices ? indices.length : positions.length / 3
}

function vertexAt({ indices }: MetricMesh, corner: number): number {
  return indices ? indices[corner] : corner
}

/** Returns uu, uv and vv per vertex: the area-weighted mean over the vertex's triangles, NaN if all of them are degenerate. */
function vertexForms(mesh: MetricMesh, scale: number): Float64Array {
  const { positions, uvs } = mesh
  const vertices = positions.length / 3
  const forms = new Float64Array(3 * vertices)
  const areas = new Float64Array(vertices)
  for (let t = 0; t + 2 < cornerCount(mesh); t += 3) {
    const [a, b, c] = [vertexAt(mesh, t), vertexAt(mesh, t + 1), vertexAt(mesh, t + 2)]
    const [u1, v1] = [uvs[2 * b] - uvs[2 * a], uvs[2 * b + 1] - uvs[2 * a + 1]]
    const [u2, v2] = [uvs[2 * c] - uvs[2 * a], uvs[2 * c + 1] - uvs[2 * a + 1]]
    const det = u1 * v2 - u2 * v1
    if (Math.abs(det) < 1e-14) continue
    // P(u, v) is linear on a triangle: `[Pu Pv] = [e1 e2] * inverse([u1 u2; v1 v2])`.
    let [uu, uv, vv] = [0, 0, 0]
    for (let k = 0; k < 3; k++) {
      const e1 = scale * (positions[3 * b + k] - positions[3 * a + k])
      const e2 = scale * (positions[3 * c + k] - positions[3 * a + k])
      const pu = (e1 * v2 - e2 * v1) / det
      const pv = (e2 * u1 - e1 * u2) / det
      uu += pu * pu
      uv += pu * pv
      vv += pv * pv
    }
    const area = Math.sqrt(Math.max(uu * vv - uv * uv, 0)) * Math.abs(det)
    if (!(area > 0)) continue
    for (const i of [a, b, c]) {
      forms[3 * i] += area * uu
      forms[3 * i + 1] += area * uv
      forms[3 * i + 2] += area * vv
      areas[i] += area
    }
  }
  for (let i = 0; i < forms.length; i++) forms[i] /= areas[Math.floor(i / 3)]
  return forms
}

function rasterizeForms(metric: Metric, mesh: MetricMesh, forms: Float64Array, corner: number): void {
  const vertices = [vertexAt(mesh, corner), vertexAt(mesh, corner + 1), vertexAt(mesh, corner + 2)] as const
  const [i, j, k] = vertices
  if (Number.isNaN(forms[3 * i] + forms[3 * j] + forms[3 * k])) return
  const form = new Float64Array(3)
  coverTexels(mesh.uvs, vertices, metric.width, metric.height, (texel, a, b, c) => {
    if (metric.inside[texel]) return
    interpolate(form, forms, 3, i, j, k, a, b, c)
    const limit = Math.sqrt((1 - MIN_SQUARED_SINE) * form[0] * form[2])
    metric.uu[texel] = form[0]
    metric.uv[texel] = clamp(form[1], -limit, limit)
    metric.vv[texel] = form[2]
    metric.inside[texel] = 1
  })
}

function checkSize(side: number): void {
  if (Number.isInteger(side) && side >= 1 && side <= MAX_IMAGE_SIDE) return
  throw new FurrowError({
    code: 'out-of-range',
    who: 'surfaceMetric',
    problem: 'invalid map size',
    value: side,
    limit: `whole numbers, 1..${MAX_IMAGE_SIDE} texels`,
    remedy: 'choose a common size such as 1024',
  })
}

function checkMesh({ positions, uvs, indices }: MetricMesh): void {
  const vertices = positions.length / 3
  const fail = (problem: string, value: unknown, limit: string) => {
    throw new FurrowError({
      who: 'surfaceMetric',
      problem,
      value,
      limit,
      remedy: 'check how the mesh was read',
    })
  }
  if (!Number.isInteger(vertices) || vertices < 3) {
    fail('positions must have x, y and z per vertex', positions.length, 'a multiple of 3, at least 9')
  }
  if (uvs.length !== 2 * vertices) {
    fail('wrong number of texture coordinates', uvs.length, `${2 * vertices}, two per vertex`)
  }
  for (let i = 0; i < positions.length; i++) {
    if (!Number.isFinite(positions[i]))
      fail(`positions[${i}] is NaN or infinite`, positions[i], 'finite metres')
  }
  for (let i = 0; i < uvs.length; i++) {
    if (!Number.isFinite(uvs[i])) fail(`uvs[${i}] is NaN or infinite`, uvs[i], 'finite texture coordinates')
  }
  for (let i = 0; indices && i < indices.length; i++) {
    const index = indices[i]
    if (!(index >= 0 && index < vertices)) fail(`indices[${i}] is out of range`, index, `0..${vertices - 1}`)
  }
}
