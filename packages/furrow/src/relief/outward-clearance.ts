import { MAX_RELIEF } from '../core/limits.ts'
import { powerOfTwoFrom } from '../math/scalar.ts'
import type { CoarseMesh } from './coarse-mesh.ts'
import { CLEARANCE_TO_CURVE, smoothNormals } from './displaced.ts'
import { PairNumbers } from './pair-numbers.ts'
import { nextCorner } from './welded-edges.ts'

/** Two facing surfaces may each fill this fraction of the gap between them. */
const OF_GAP = 0.4

/** Clearance of a vertex, as a fraction of its distance from the nearest rim. */
const FROM_RIM = 0.25

/** Normals are opposed if the cosine of the angle between them is below this number. */
const OPPOSED = -0.2

/**
 * Computes the clearance of each vertex: how far the surface may be displaced outwards without touching another part of the mesh. Where two
 * surfaces face each other, such as the lips, each may fill less than half of the gap. Rims, such as the edges of eyelids, touch other parts
 * when the face moves. The clearance is therefore 0 on rims and grows with the distance from them.
 *
 * @param normals unit normals at rest.
 * @param firstOf maps each vertex to the first vertex at the same position; see `firstVertices`.
 * @param reach maximum displacement by height maps, in metres. A returned clearance above `reach` is not exact.
 * @returns generator that yields between parts of the work, and returns the clearance of each vertex, in metres.
 */
export function* outwardClearance(
  { positions, triangles }: CoarseMesh,
  normals: ArrayLike<number>,
  firstOf: Uint32Array,
  reach: number,
): Generator<void, Float32Array> {
  const smooth = smoothNormals(normals, firstOf)
  const isRim = rims(triangles, smooth, firstOf)
  yield
  const points = firstOf.filter((first, vertex) => first === vertex)
  const rim = points.filter((i) => isRim[i])
  const most = Math.max(reach, CLEARANCE_TO_CURVE)
  const clearance = new Float32Array(firstOf.length)
  const grid = new PointGrid(positions, points, most / OF_GAP)
  const rimGrid = new PointGrid(positions, rim, most / FROM_RIM)
  const isAny = () => true
  const isFaced = (j: number, i: number) => isFacing(positions, smooth, i, j)
  for (const [k, i] of grid.points().entries()) {
    if (k % SLICE === 0) yield
    const fromRim = rimGrid.nearest(i, isAny) * FROM_RIM
    const ofGap = grid.nearest(i, isFaced) * OF_GAP
    clearance[i] = Math.min(fromRim, ofGap, MAX_RELIEF)
  }
  for (let i = 0; i < clearance.length; i++) clearance[i] = clearance[firstOf[i]]
  return clearance
}

/** Number of points between two yields. */
const SLICE = 512

/** Whether point `j` is in front of the surface at point `i`, and the surfaces at both points face each other. */
function isFacing(positions: ArrayLike<number>, smooth: Float64Array, i: number, j: number): boolean {
  if (i === j || dot(smooth, 3 * i, smooth, 3 * j) >= OPPOSED) return false
  let ahead = 0
  for (let k = 0; k < 3; k++) ahead += smooth[3 * i + k] * (positions[3 * j + k] - positions[3 * i + k])
  return ahead >= 0
}

/**
 * Returns 1 for each vertex on a rim, 0 for the others. A rim is the border of the mesh, or an edge with opposed normals at its ends. Only the
 * first vertex at a position is marked.
 */
function rims(triangles: ArrayLike<number>, smooth: Float64Array, firstOf: Uint32Array): Uint8Array {
  const isRim = new Uint8Array(firstOf.length)
  const corners = triangles.length - (triangles.length % 3)
  const edges = new PairNumbers(corners)
  const edgeOf = new Uint32Array(corners)
  const sides = new Uint32Array(corners)
  for (let corner = 0; corner < corners; corner++) {
    const a = firstOf[triangles[corner]]
    const b = firstOf[triangles[nextCorner(corner)]]
    edgeOf[corner] = a < b ? edges.numberOf(a, b) : edges.numberOf(b, a)
    sides[edgeOf[corner]]++
    if (dot(smooth, 3 * a, smooth, 3 * b) < OPPOSED) isRim[a] = isRim[b] = 1
  }
  for (let corner = 0; corner < corners; corner++) {
    if (sides[edgeOf[corner]] > 1) continue
    isRim[firstOf[triangles[corner]]] = 1
    isRim[firstOf[triangles[nextCorner(corner)]]] = 1
  }
  return isRim
}

/** Points in a grid of cubic cells, for nearest-neighbour queries. Cells are stored in a hash table. */
class PointGrid {
  readonly #positions: ArrayLike<number>
  readonly #side: number
  /** Integer coordinates of each vertex's cell, packed xyz. */
  readonly #cubes: Int32Array
  /** Hash table of cells, with linear probing. A slot stores 1 plus the index of the last point in the cell, or 0 if it is free. */
  readonly #last: Uint32Array
  /** Linked lists of the points in each cell. For each point, 1 plus the index of the previous point in the same cell, or 0. */
  readonly #before: Uint32Array
  readonly #count: number
  /** Coordinates of the cell of the last query. `#around` stays valid for the next query in the same cell. */
  readonly #middle = [NaN, NaN, NaN]
  /** For each occupied cell around the last query, 1 plus the index of its last point. */
  readonly #around = new Uint32Array(27)
  #near = 0

  constructor(positions: ArrayLike<number>, points: Uint32Array, side: number) {
    this.#positions = positions
    this.#side = side
    this.#count = points.length
    this.#cubes = Int32Array.from(positions, (coordinate) => Math.floor(coordinate / side))
    this.#last = new Uint32Array(powerOfTwoFrom(2 * points.length + 2))
    this.#before = new Uint32Array(positions.length / 3)
    for (let k = 0; k < points.length; k++) {
      const i = points[k]
      const slot = this.#slotOf(this.#cubes[3 * i], this.#cubes[3 * i + 1], this.#cubes[3 * i + 2])
      this.#before[i] = this.#last[slot]
      this.#last[slot] = i + 1
    }
  }

  /** Returns the indices of all points. Points in the same cell are consecutive. */
  points(): Uint32Array {
    const all = new Uint32Array(this.#count)
    let count = 0
    for (let slot = 0; slot < this.#last.length; slot++) {
      for (let next = this.#last[slot]; next > 0; next = this.#before[next - 1]) all[count++] = next - 1
    }
    return all
  }

  /** Returns the distance from point `i` to the nearest point `j` that fulfils a condition, or Infinity if none is within one cell size. */
  nearest(i: number, condition: (j: number, i: number) => boolean): number {
    this.#lookAround(this.#cubes[3 * i], this.#cubes[3 * i + 1], this.#cubes[3 * i + 2])
    let least = this.#side ** 2
    let isFound = false
    for (let k = 0; k < this.#near; k++) {
      for (let next = this.#around[k]; next > 0; next = this.#before[next - 1]) {
        const squared = this.#squaredDistance(i, next - 1)
        if (squared > least || !condition(next - 1, i)) continue
        least = squared
        isFound = true
      }
    }
    return isFound ? Math.sqrt(least) : Infinity
  }

  /** Sets `#around` to the occupied cells among a cell and its 26 neighbours. */
  #lookAround(x: number, y: number, z: number): void {
    const middle = this.#middle
    if (middle[0] === x && middle[1] === y && middle[2] === z) return
    middle[0] = x
    middle[1] = y
    middle[2] = z
    this.#near = 0
    for (let dx = -1; dx <= 1; dx++) {
      for (let dy = -1; dy <= 1; dy++) {
        for (let dz = -1; dz <= 1; dz++) {
          const last = this.#last[this.#slotOf(x + dx, y + dy, z + dz)]
          if (last > 0) this.#around[this.#near++] = last
        }
      }
    }
  }

  #squaredDistance(i: number, j: number): number {
    const x = this.#positions[3 * j] - this.#positions[3 * i]
    const y = this.#positions[3 * j + 1] - this.#positions[3 * i + 1]
    const z = this.#positions[3 * j + 2] - this.#positions[3 * i + 2]
    return x * x + y * y + z * z
  }

  /** Returns the slot of a cell in `#last`, or a free slot if the cell has no points. */
  #slotOf(x: number, y: number, z: number): number {
    const h = Math.imul(x, 0x9e3779b1) ^ Math.imul(y, 0x85ebca6b) ^ Math.imul(z, 0xc2b2ae35)
    const mask = this.#last.length - 1
    for (let slot = (h ^ (h >>> 15)) & mask; ; slot = (slot + 1) & mask) {
      const k = 3 * (this.#last[slot] - 1)
      if (k < 0 || (this.#cubes[k] === x && this.#cubes[k + 1] === y && this.#cubes[k + 2] === z)) return slot
    }
  }
}

function dot(a: ArrayLike<number>, i: number, b: ArrayLike<number>, j: number): number {
  return a[i] * b[j] + a[i + 1] * b[j + 1] + a[i + 2] * b[j + 2]
}
