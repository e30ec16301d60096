import { FurrowError } from '../core/error.ts'
import { MAX_IMAGE_SIDE } from '../core/limits.ts'
import { coverTexels } from './cover-texels.ts'

/** What the metric needs of a mesh. Nothing is changed or kept. */
export interface MetricMesh {
  /** x, y, z per vertex, in metres. */
  positions: ArrayLike<number>
  /** u, v per vertex, v = 0 at the top. */
  uvs: ArrayLike<number>
  /** Three per triangle; when absent the vertices are taken three by three. */
  indices?: ArrayLike<number>
}

/**
 * The true size of the texture on the skin: per texel the first fundamental form of the surface P(u, v)
 * (do Carmo, Differential Geometry of Curves and Surfaces, 2.5). A small step (du, dv) is
 * sqrt(uu du^2 + 2 uv du dv + vv dv^2) millimetres long. Row 0 is v = 0.
 */
export interface Metric {
  width: number
  height: number
  /** dP/du . dP/du in mm^2 per unit of u^2, width x height values. */
  uu: Float32Array
  /** dP/du . dP/dv in mm^2. */
  uv: Float32Array
  /** dP/dv . dP/dv in mm^2. */
  vv: Float32Array
  /** 1 where a triangle covers the texel's centre, 0 where the values were carried outwards. */
  inside: Uint8Array
}

/** Squared sine below which a stretched triangle is taken as no wider than this: keeps distances finite. */
const THINNEST = 1e-4

/**
 * Measures a mesh in its texture. Values are averaged at the vertices (by area, so that the triangles do not
 * show), interpolated inside them and carried from the islands outwards to the nearest texels.
 * `width` and `height` are in texels. Where islands overlap the last triangle wins.
 * Throws FurrowError where the mesh has no triangle in the texture, or its arrays do not fit together.
 */
export function surfaceMetric(mesh: MetricMesh, width: number, height = width): Metric {
  checkSize(width)
  checkSize(height)
  checkMesh(mesh)
  const vertex = vertexForms(mesh)
  const texels = width * height
  const metric: Metric = {
    width,
    height,
    uu: new Float32Array(texels),
    uv: new Float32Array(texels),
    vv: new Float32Array(texels),
    inside: new Uint8Array(texels),
  }
  const corners = mesh.indices ?? { length: mesh.positions.length / 3 }
  for (let t = 0; t + 2 < corners.length; t += 3) rasterise(mesh, vertex, t, metric)
  extend(metric)
  return metric
}

/** Reads the metric between texels: bilinear, clamped at the border. Writes [uu, uv, vv] into `out`. */
export function metricAt(metric: Metric, u: number, v: number, out: Float64Array): void {
  const { width, height } = metric
  const x = Math.min(Math.max(u * width - 0.5, 0), width - 1)
  const y = Math.min(Math.max(v * height - 0.5, 0), height - 1)
  const x0 = Math.floor(x)
  const y0 = Math.floor(y)
  const right = Math.min(x0 + 1, width - 1) - x0
  const a = y0 * width + x0
  const b = Math.min(y0 + 1, height - 1) * width + x0
  const fx = x - x0
  const fy = y - y0
  const mix = (map: Float32Array) =>
    (1 - fy) * ((1 - fx) * map[a] + fx * map[a + right]) + fy * ((1 - fx) * map[b] + fx * map[b + right])
  out[0] = mix(metric.uu)
  out[1] = mix(metric.uv)
  out[2] = mix(metric.vv)
}

function corner(mesh: MetricMesh, i: number): number {
  return mesh.indices ? mesh.indices[i] : i
}

/** uu, uv, vv and total weight per vertex, averaged over its triangles by their area in space. */
function vertexForms({ positions, uvs, indices }: MetricMesh): Float64Array {
  const sums = new Float64Array((positions.length / 3) * 4)
  const count = indices ? indices.length : positions.length / 3
  const mesh = { positions, uvs, indices } as MetricMesh
  for (let t = 0; t + 2 < count; t += 3) {
    const [a, b, c] = [corner(mesh, t), corner(mesh, t + 1), corner(mesh, t + 2)]
    const [u1, v1] = [uvs[2 * b] - uvs[2 * a], uvs[2 * b + 1] - uvs[2 * a + 1]]
    const [u2, v2] = [uvs[2 * c] - uvs[2 * a], uvs[2 * c + 1] - uvs[2 * a + 1]]
    const det = u1 * v2 - u2 * v1
    if (Math.abs(det) < 1e-14) continue
    // P(u, v) is linear on a triangle: [Pu Pv] = [e1 e2] inverse([u1 u2; v1 v2]).
    const pu = [0, 0, 0]
    const pv = [0, 0, 0]
    for (let k = 0; k < 3; k++) {
      const e1 = 1000 * (positions[3 * b + k] - positions[3 * a + k])
      const e2 = 1000 * (positions[3 * c + k] - positions[3 * a + k])
      pu[k] = (e1 * v2 - e2 * v1) / det
      pv[k] = (e2 * u1 - e1 * u2) / det
    }
    const uu = pu[0] ** 2 + pu[1] ** 2 + pu[2] ** 2
    const vv = pv[0] ** 2 + pv[1] ** 2 + pv[2] ** 2
    const uv = pu[0] * pv[0] + pu[1] * pv[1] + pu[2] * pv[2]
    const area = Math.sqrt(Math.max(uu * vv - uv * uv, 0)) * Math.abs(det)
    if (!(area > 0)) continue
    for (const i of [a, b, c]) {
      sums[4 * i] += area * uu
      sums[4 * i + 1] += area * uv
      sums[4 * i + 2] += area * vv
      sums[4 * i + 3] += area
    }
  }
  return sums
}

function rasterise(mesh: MetricMesh, vertex: Float64Array, t: number, metric: Metric): void {
  const { width, height } = metric
  const ids = [corner(mesh, t), corner(mesh, t + 1), corner(mesh, t + 2)] as const
  if (ids.some((i) => vertex[4 * i + 3] === 0)) return
  const form = ids.map((i) => [0, 1, 2].map((k) => vertex[4 * i + k] / vertex[4 * i + 3]))
  coverTexels(mesh.uvs, ids, width, height, (texel, a, b, c) => {
    const mix = (k: number) => a * form[0][k] + b * form[1][k] + c * form[2][k]
    const [uu, vv] = [mix(0), mix(2)]
    const limit = Math.sqrt((1 - THINNEST) * uu * vv)
    metric.uu[texel] = uu
    metric.uv[texel] = Math.min(Math.max(mix(1), -limit), limit)
    metric.vv[texel] = vv
    metric.inside[texel] = 1
  })
}

/** Carries the values outwards from the islands, ring by ring (breadth first over the four neighbours). */
function extend(metric: Metric): void {
  const { width, height, inside, uu, uv, vv } = metric
  const reached = Uint8Array.from(inside)
  const queue = new Uint32Array(width * height)
  let end = 0
  for (let i = 0; i < reached.length; i++) if (reached[i]) queue[end++] = i
  if (end === 0) {
    throw new FurrowError({
      who: 'surfaceMetric',
      what: 'no triangle of the mesh covers a texel of the map',
      limit: 'texture coordinates within 0..1 and triangles with area',
      remedy: 'check the mesh for texture coordinates',
    })
  }
  for (let head = 0; head < end; head++) {
    const from = queue[head]
    const x = from % width
    const next = [
      x > 0 ? from - 1 : -1,
      x < width - 1 ? from + 1 : -1,
      from - width,
      from + width < width * height ? from + width : -1,
    ]
    for (const to of next) {
      if (to < 0 || reached[to]) continue
      reached[to] = 1
      uu[to] = uu[from]
      uv[to] = uv[from]
      vv[to] = vv[from]
      queue[end++] = to
    }
  }
}

function checkSize(side: number): void {
  if (Number.isInteger(side) && side >= 1 && side <= MAX_IMAGE_SIDE) return
  throw new FurrowError({
    who: 'surfaceMetric',
    what: 'the size of the map is no texture size',
    value: side,
    limit: `whole numbers, 1..${MAX_IMAGE_SIDE} texels`,
    remedy: 'choose a usual size such as 1024',
  })
}

function checkMesh({ positions, uvs, indices }: MetricMesh): void {
  const vertices = positions.length / 3
  const fail = (what: string, value: unknown, limit: string) => {
    throw new FurrowError({ who: 'surfaceMetric', what, value, limit, remedy: 'check how the mesh was read' })
  }
  if (!Number.isInteger(vertices) || vertices < 3) {
    fail('positions are not x, y, z per vertex', positions.length, 'a multiple of 3, at least 9')
  }
  if (uvs.length !== 2 * vertices) {
    fail('texture coordinates do not match the vertices', uvs.length, `${2 * vertices} numbers`)
  }
  for (let i = 0; i < positions.length; i++) {
    if (!Number.isFinite(positions[i])) fail(`positions[${i}] is no number`, positions[i], 'finite metres')
  }
  for (let i = 0; i < uvs.length; i++) {
    if (!Number.isFinite(uvs[i])) fail(`uvs[${i}] is no number`, uvs[i], 'finite texture coordinates')
  }
  for (let i = 0; indices && i < indices.length; i++) {
    const index = indices[i]
    if (!(index >= 0 && index < vertices)) fail(`indices[${i}] is no vertex`, index, `0..${vertices - 1}`)
  }
}
