import { hash32 } from '../../math/hash.ts'
import { triangleNormal } from '../../math/triangle.ts'
import { normalize } from '../../math/vector.ts'
import { cornersOf, crossOf, type SkinSurface, triangleBox } from '../skin/surface.ts'
import { barycentricsAt } from '../skin/walk.ts'
import { TENSOR } from './direction-field.ts'
import type { LocalCells } from './local-cells.ts'
import { SeedGrid } from './seed-grid.ts'

/** Seeds of a cellular texture. The cell of a seed consists of the points that are nearer to it than to any other seed. */
export interface Seeds {
  /** Packed xyz. */
  positions: Float64Array
  /** Symmetric matrix of each seed, `TENSOR` numbers. It measures squared distances from the seed; see `squareBy`. */
  metrics: Float64Array
  /** Size of each cell in millimetres. */
  sizes: Float64Array
  /** Random factor, at most 1, on distances from each seed in all directions. The seed's matrix includes this factor. */
  scales: Float64Array
  /** Visibility of the furrows around each seed at the map's resolution, 0..1. */
  visible: Float64Array
  /** Random integer of each seed. */
  hashes: Uint32Array
}

/** Parameters of `scatterSeeds`. */
export interface CellSource {
  surface: SkinSurface
  /** Result of `directionsAlong` for the surface. */
  directions: Float64Array
  cells: LocalCells
  /** Ratio of a cell's length to its width on a wrinkle line. */
  stretch: number
  seed: number
  /** Factor on the cell sizes of `cells`. */
  part: number
  /** Returns the visibility, 0..1, of a furrow on a triangle. It is 0 if the width, in millimetres, is too small for the texels. */
  visible(triangle: number, width: number): number
}

/** Width of a furrow as a fraction of the cell size. */
export const FURROW_WIDTH = 0.3

/** Spacing of the lattice of candidates for seeds, as a fraction of the smallest cell size. */
const LATTICE = 0.5
/** Maximum distance of candidates from the skin, in lattice spacings. A square of skin one spacing wide then has about one candidate. */
const SHELL = 0.5
/** Minimum distance between seeds as a fraction of the cell size. The mean distance between neighbours is then about the cell size. */
const SEED_SPACING = 0.8
/**
 * Maximum random reduction of distances from a seed, as a fraction. Without a reduction, all borders of cells are straight and the skin looks
 * like scales. With the reduction, borders are arcs and cells differ in size (a multiplicatively weighted Voronoi diagram).
 */
const MAX_SHORTENING = 0.35
/** Maximum edge length of a triangle in lattice spacings. Larger triangles are split before the search for nearby lattice points. */
const MAX_EDGE = 8
/** Approximate maximum number of candidates. It limits how fine the lattice can be. */
const MAX_CANDIDATES = 1_500_000

/**
 * Scatters seeds over the skin by Poisson disk sampling. Candidates are the points of a jittered 3D lattice that are close to the skin. They do
 * not depend on triangles and UVs. Near wrinkle lines, the disks are ellipses whose long axes follow the lines.
 */
export function scatterSeeds(source: CellSource): Seeds {
  const candidates = candidatesOn(source)
  const { positions, metrics, sizes } = candidates
  const count = sizes.length
  const largest = SEED_SPACING * source.part * source.cells.largest * source.stretch
  const grid = new SeedGrid(positions, largest)
  const kept: number[] = []
  for (const index of inRandomOrder(candidates.hashes)) {
    const position = positions.subarray(3 * index, 3 * index + 3)
    const [x, y, z] = position
    const radius = SEED_SPACING * sizes[index]
    const near = grid.search(position, position, radius * source.stretch)
    let isFree = true
    for (let n = 0; n < near.length && isFree; n++) {
      const other = 3 * near[n]
      const [dx, dy, dz] = [positions[other] - x, positions[other + 1] - y, positions[other + 2] - z]
      isFree = squareBy(metrics, TENSOR * index, dx, dy, dz) >= (candidates.scales[index] * radius) ** 2
    }
    if (!isFree) continue
    grid.add(index)
    kept.push(index)
  }
  if (kept.length === count) return candidates
  const pick = (values: Float64Array, stride: number) => {
    const out = new Float64Array(stride * kept.length)
    for (const [i, index] of kept.entries())
      out.set(values.subarray(stride * index, stride * (index + 1)), stride * i)
    return out
  }
  return {
    positions: pick(positions, 3),
    metrics: pick(metrics, TENSOR),
    sizes: pick(sizes, 1),
    scales: pick(candidates.scales, 1),
    visible: pick(candidates.visible, 1),
    hashes: Uint32Array.from(kept, (index) => candidates.hashes[index]),
  }
}

/** Returns the squared length of the vector d = (`dx`, `dy`, `dz`): `transpose(d) * M * d`, with the matrix M at offset `i` of `m`. */
export function squareBy(m: Float64Array, i: number, dx: number, dy: number, dz: number): number {
  return (
    m[i] * dx * dx +
    m[i + 1] * dy * dy +
    m[i + 2] * dz * dz +
    2 * (m[i + 3] * dx * dy + m[i + 4] * dx * dz + m[i + 5] * dy * dz)
  )
}

function inRandomOrder(hashes: Uint32Array): Uint32Array {
  // Pack hash and index into the 53 bits of a number.
  const bits = 2 ** 21
  const keys = Float64Array.from(hashes, (hash, i) => hash * bits + (i % bits)).sort()
  return Uint32Array.from(keys, (key) => key % bits)
}

/** Returns the candidates for seeds: the lattice points that are close to skin with visible furrows. */
function candidatesOn(source: CellSource): Seeds {
  const { surface, cells, part, seed } = source
  const triangles = visibleTriangles(source)
  const area = triangles.reduce((sum, { area }) => sum + area, 0)
  const side = Math.max(LATTICE * part * cells.smallest, Math.sqrt(area / MAX_CANDIDATES))
  const [positions, metrics, sizes, scales, visibles, hashes]: number[][] = [[], [], [], [], [], []]
  const seen = new Set<number>()
  const [point, weights, normal] = [new Float64Array(3), new Float64Array(3), new Float64Array(3)]
  const metric = new Float64Array(TENSOR)

  const tryCell = ({ triangle, visible }: VisibleTriangle, i: number, j: number, k: number) => {
    const hash = hash32(Math.imul(i, 0x8da6b343) ^ Math.imul(j, 0xd8163841) ^ Math.imul(k, 0xcb1ab31f) ^ seed)
    point[0] = (i + (hash & 1023) / 1024) * side
    point[1] = (j + ((hash >>> 10) & 1023) / 1024) * side
    point[2] = (k + ((hash >>> 20) & 1023) / 1024) * side
    let away = 0
    for (let n = 0; n < 3; n++)
      away += normal[n] * (point[n] - surface.points[3 * surface.corners[3 * triangle] + n])
    if (Math.abs(away) >= SHELL * side) return
    barycentricsAt(weights, surface, triangle, point)
    if (!(weights[0] >= 0 && weights[1] >= 0 && weights[2] >= 0)) return
    cells.find(point[0], point[1], point[2])
    if (cells.depth === 0) return
    // Two triangles can reach the same lattice point.
    const key = ((i & 0x1ffff) * 0x20000 + (j & 0x1ffff)) * 0x20000 + (k & 0x1ffff)
    if (seen.has(key)) return
    seen.add(key)
    const scale = 1 - MAX_SHORTENING * (hash32(~hash) / 2 ** 32)
    metricAt(metric, source, triangle, weights, scale)
    positions.push(point[0], point[1], point[2])
    metrics.push(metric[0], metric[1], metric[2], metric[3], metric[4], metric[5])
    sizes.push(part * cells.size)
    scales.push(scale)
    visibles.push(visible)
    hashes.push(hash32(hash ^ k))
  }
  const visitBox = (triangle: VisibleTriangle, a: Position, b: Position, c: Position) => {
    const longest = longestEdge(a, b, c)
    if (longest.square > (MAX_EDGE * side) ** 2) {
      const [from, to, other] = longest.corners
      const middle = [0, 1, 2].map((n) => (from[n] + to[n]) / 2)
      visitBox(triangle, from, middle, other)
      visitBox(triangle, middle, to, other)
      return
    }
    const cell = (n: number, least: boolean) =>
      Math.floor(
        (least ? Math.min(a[n], b[n], c[n]) : Math.max(a[n], b[n], c[n])) / side + (least ? -1 : 1) * SHELL,
      )
    const [i1, j1, k1] = [cell(0, false), cell(1, false), cell(2, false)]
    for (let i = cell(0, true); i <= i1; i++) {
      for (let j = cell(1, true); j <= j1; j++) {
        for (let k = cell(2, true); k <= k1; k++) tryCell(triangle, i, j, k)
      }
    }
  }
  for (const visible of triangles) {
    const [a, b, c] = cornersOf(surface, visible.triangle)
    const at = (corner: number) => surface.points.subarray(3 * corner, 3 * corner + 3)
    triangleNormal(normal, surface.points, a, b, c)
    normalize(normal)
    visitBox(visible, at(a), at(b), at(c))
  }
  return {
    positions: Float64Array.from(positions),
    metrics: Float64Array.from(metrics),
    sizes: Float64Array.from(sizes),
    scales: Float64Array.from(scales),
    visible: Float64Array.from(visibles),
    hashes: Uint32Array.from(hashes),
  }
}

interface VisibleTriangle {
  triangle: number
  area: number
  /** Visibility of the triangle's furrows at the map's resolution, above 0 and at most 1. */
  visible: number
}

/** Returns the triangles on which furrows are visible at the map's resolution. */
function visibleTriangles({ surface, cells, part, visible }: CellSource): VisibleTriangle[] {
  const found: VisibleTriangle[] = []
  const [low, high, normal] = [new Float64Array(3), new Float64Array(3), new Float64Array(3)]
  const { points } = surface
  for (let triangle = 0; triangle < surface.skinTriangles.length; triangle++) {
    triangleBox(surface, triangle, low, high)
    if (!cells.isIn(low, high)) continue
    const [a, b, c] = cornersOf(surface, triangle)
    const centre = (k: number) => (points[3 * a + k] + points[3 * b + k] + points[3 * c + k]) / 3
    cells.find(centre(0), centre(1), centre(2))
    const seen = visible(triangle, FURROW_WIDTH * part * cells.size)
    if (seen > 0) found.push({ triangle, area: crossOf(points, a, b, c, normal) / 2, visible: seen })
  }
  return found
}

type Position = ArrayLike<number>

/** Returns the squared length of a triangle's longest edge, and the corners: first the two ends of the edge, then the third corner. */
function longestEdge(a: Position, b: Position, c: Position) {
  const square = (p: Position, q: Position) => (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2 + (p[2] - q[2]) ** 2
  const [ab, bc, ca] = [square(a, b), square(b, c), square(c, a)]
  if (ab >= bc && ab >= ca) return { square: ab, corners: [a, b, c] as const }
  if (bc >= ca) return { square: bc, corners: [b, c, a] as const }
  return { square: ca, corners: [c, a, b] as const }
}

/**
 * Computes the matrix that measures squared distances at a position: `scale ** 2 * (I - (1 - 1 / stretch ** 2) * D)`, where D is the matrix of
 * `directionsAlong`. Along wrinkle lines, the measured distances are shorter.
 */
function metricAt(
  out: Float64Array,
  source: CellSource,
  triangle: number,
  weights: Float64Array,
  scale: number,
): void {
  const { surface, directions, stretch } = source
  const less = 1 - 1 / stretch ** 2
  for (let k = 0; k < TENSOR; k++) {
    let along = 0
    for (let n = 0; n < 3; n++)
      along += weights[n] * directions[TENSOR * surface.corners[3 * triangle + n] + k]
    out[k] = scale ** 2 * ((k < 3 ? 1 : 0) - less * along)
  }
}
