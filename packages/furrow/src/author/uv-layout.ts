import type { RgbaImage } from '../core/types.ts'
import { rasterize } from '../math/rasterize.ts'
import { clamp } from '../math/scalar.ts'
import { length2 } from '../math/vector.ts'
import type { MetricMesh } from './metric.ts'
import { checkCoverage } from './skin/check-coverage.ts'
import { weldSurface } from './skin/surface.ts'

/** Colours in sRGB. */
const SKIN = [214, 212, 210]
const WIRE = [40, 44, 52]
const SEAM = [226, 88, 34]

/** Line widths in texels. Edges that are at least `SPARSE` texels long have the opacity `WIRE_OPACITY`; shorter edges are fainter. */
const WIRE_WIDTH = 0.8
const SEAM_WIDTH = 2
const WIRE_OPACITY = 0.5
const SPARSE = 12

/** Opacity of the base colour, 0..1. */
const BASE_OPACITY = 0.6

/** Direction to the light. The face looks along +z. The light is in front of the face, above it, and on the viewer's left. */
const LIGHT = [-0.35, 0.45, 0.82]

export interface UvLayoutOptions {
  /** Base colour map, RGBA in sRGB, `size * size` texels; drawn faintly. Default: light gray. */
  base?: RgbaImage
}

/**
 * Draws the UV layout of a mesh as a painting template: shaded islands, thin edges and thick island borders. Texels outside the islands
 * are transparent.
 *
 * @param mesh UVs outside 0..1 are wrapped.
 * @param size width and height of the picture in texels.
 * @returns sRGB with straight alpha, row 0 at v = 0.
 * @throws FurrowError if hundreds of triangles overlap in UV space.
 */
export function drawUvLayout(mesh: MetricMesh, size: number, { base }: UvLayoutOptions = {}): RgbaImage {
  const triangles = trianglesOf(mesh, size)
  const uvs = Float64Array.from(triangles.flatMap(({ corners }) => corners.map((at) => (at + 0.5) / size)))
  checkCoverage({ uvs, indices: Uint32Array.from({ length: uvs.length / 2 }, (_, i) => i) }, 'drawUvLayout')
  const data = new Uint8Array(4 * size * size)
  const shade = vertexShades(mesh)
  for (const { vertices, corners } of triangles) {
    const [p, q, r] = vertices.map((vertex) => shade[vertex])
    rasterize(
      corners,
      0.001,
      (column, row, a, b, c) => {
        const texel = 4 * (row * size + column)
        const light = a * p + b * q + c * r
        for (let k = 0; k < 3; k++) {
          const skin = SKIN[k] * light
          data[texel + k] = base ? skin + (base.data[texel + k] - skin) * BASE_OPACITY : skin
        }
        data[texel + 3] = 255
      },
      [0, 0, size - 1, size - 1],
    )
  }
  const [wires, seams] = [new Float32Array(size * size), new Float32Array(size * size)]
  for (const { start, end, count } of edgesOf(mesh, triangles)) {
    const length = length2(end[0] - start[0], end[1] - start[1])
    drawLine(wires, size, start, end, WIRE_WIDTH, WIRE_OPACITY * clamp(length / SPARSE, 0.2, 1))
    if (count === 1) drawLine(seams, size, start, end, SEAM_WIDTH, 1)
  }
  lay(data, wires, WIRE)
  lay(data, seams, SEAM)
  return { width: size, height: size, data }
}

interface LaidTriangle {
  vertices: [number, number, number]
  /** x and y of each corner in texels; texel centres are at whole numbers. */
  corners: number[]
}

/** Returns the triangles of a mesh, each moved by whole UV tiles so that its centroid is within 0..1. */
function trianglesOf({ positions, uvs, indices }: MetricMesh, size: number): LaidTriangle[] {
  const corners = indices ?? Array.from({ length: positions.length / 3 }, (_, i) => i)
  const triangles: LaidTriangle[] = []
  for (let t = 0; t + 2 < corners.length; t += 3) {
    const vertices: LaidTriangle['vertices'] = [corners[t], corners[t + 1], corners[t + 2]]
    const tile = [0, 1].map((k) => Math.floor(vertices.reduce((sum, i) => sum + uvs[2 * i + k], 0) / 3))
    const at = vertices.flatMap((i) => [0, 1].map((k) => (uvs[2 * i + k] - tile[k]) * size - 0.5))
    if (at.every(Number.isFinite)) triangles.push({ vertices, corners: at })
  }
  return triangles
}

/** Shades vertices by their smooth normals: 0.7 (dark) to 1 (lit). */
function vertexShades({ positions, indices }: MetricMesh): Float64Array {
  const count = positions.length / 3
  const { normals, pointOf } = weldSurface({
    positions,
    indices: indices ?? Array.from({ length: count }, (_, i) => i),
  })
  return Float64Array.from({ length: count }, (_, i) => {
    const point = 3 * pointOf[i]
    const cosine = LIGHT.reduce((sum, value, k) => sum + value * normals[point + k], 0)
    return 0.85 + 0.15 * (Number.isFinite(cosine) ? cosine : 0)
  })
}

interface Edge {
  start: [x: number, y: number]
  end: [x: number, y: number]
  /** Number of triangles that share the edge in the layout: 1 at the border of an island. */
  count: number
}

function edgesOf({ positions, uvs }: MetricMesh, triangles: readonly LaidTriangle[]): Iterable<Edge> {
  // Merge vertices with the same position and UV coordinates, even if they have different normals.
  const points = new Map<string, number>()
  const pointOf = (vertex: number) => {
    const key =
      [0, 1, 2].map((k) => positions[3 * vertex + k]).join() + [0, 1].map((k) => uvs[2 * vertex + k])
    const point = points.get(key) ?? points.size
    points.set(key, point)
    return point
  }
  const edges = new Map<string, Edge>()
  for (const { vertices, corners } of triangles) {
    const ends = vertices.map(pointOf)
    for (let k = 0; k < 3; k++) {
      const next = (k + 1) % 3
      const key = ends[k] < ends[next] ? `${ends[k]} ${ends[next]}` : `${ends[next]} ${ends[k]}`
      const known = edges.get(key)
      if (known) known.count++
      else {
        const at = (corner: number): [number, number] => [corners[2 * corner], corners[2 * corner + 1]]
        edges.set(key, { start: at(k), end: at(next), count: 1 })
      }
    }
  }
  return edges.values()
}

/** Writes the opacity of a line into `coverage`, keeping the higher value where lines cross. */
function drawLine(
  coverage: Float32Array,
  size: number,
  [x0, y0]: Edge['start'],
  [x1, y1]: Edge['end'],
  width: number,
  opacity: number,
): void {
  const reach = width / 2 + 0.5
  const [dx, dy] = [x1 - x0, y1 - y0]
  const square = dx * dx + dy * dy
  const rows = [Math.min(y0, y1) - reach, Math.max(y0, y1) + reach]
  for (let y = Math.max(0, Math.ceil(rows[0])); y <= Math.min(size - 1, rows[1]); y++) {
    // Clip the line to this row and its neighbours.
    const [s, t] =
      dy === 0 ? [0, 1] : [(y - reach - y0) / dy, (y + reach - y0) / dy].map((at) => clamp(at, 0, 1))
    const [a, b] = [x0 + s * dx, x0 + t * dx]
    const last = Math.min(size - 1, Math.max(a, b) + reach)
    for (let x = Math.max(0, Math.ceil(Math.min(a, b) - reach)); x <= last; x++) {
      const along = square === 0 ? 0 : clamp(((x - x0) * dx + (y - y0) * dy) / square, 0, 1)
      const distance = length2(x - x0 - along * dx, y - y0 - along * dy)
      const covered = opacity * clamp(reach - distance, 0, 1)
      const texel = y * size + x
      if (covered > coverage[texel]) coverage[texel] = covered
    }
  }
}

/** Composites a colour over RGBA pixels (Porter and Duff's `over` operator, straight alpha). */
function lay(data: Uint8Array, coverage: Float32Array, colour: readonly number[]): void {
  for (const [i, covered] of coverage.entries()) {
    if (covered === 0) continue
    const below = (data[4 * i + 3] / 255) * (1 - covered)
    const alpha = covered + below
    for (let k = 0; k < 3; k++) {
      data[4 * i + k] = (colour[k] * covered + data[4 * i + k] * below) / alpha
    }
    data[4 * i + 3] = 255 * alpha
  }
}
