import type { CoarseMesh } from './coarse-mesh.ts'
import { ROOM_TO_CURVE, smoothNormals } from './displaced.ts'
import { PairNumbers } from './pair-numbers.ts'
import { nextCorner } from './welded-edges.ts'

/** Fraction of the gap between two surfaces that each surface may fill. */
const OF_GAP = 0.4

/** Room per distance from a rim. */
const FROM_RIM = 0.25

/** Room without obstacles, metres: more than the height of any fold. */
const AMPLE = 0.01

/** Cosine between two normals below which surfaces face each other, or an edge is a rim. */
const OPPOSED = -0.2

/**
 * Computes how far each vertex can move outwards without touching other skin. Of two surfaces that face each other, such as lips, each may
 * fill less than half of the gap. Rims, such as those of eyelids, touch other parts as the face moves: room is 0 there and grows with distance.
 *
 * @param normals unit normals at rest.
 * @param firstOf first vertex at the position of each vertex, see `firstVertices`.
 * @param reach largest displacement, metres; limits the search for obstacles.
 * @returns outward room of each vertex, metres. A generator, so that pages can spread the work over frames.
 */
export function* outwardRoom(
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
  const most = Math.max(reach, ROOM_TO_CURVE)
  const room = new Float32Array(firstOf.length)
  const grid = new PointGrid(positions, points, most / OF_GAP)
  const rimGrid = new PointGrid(positions, rim, most / FROM_RIM)
  const isAny = () => true
  const isFaced = (j: number, i: number) => isFacing(positions, smooth, i, j)
  for (const [k, i] of grid.points().entries()) {
    if (k % SLICE === 0) yield
    const fromRim = rimGrid.nearest(i, isAny) * FROM_RIM
    const ofGap = grid.nearest(i, isFaced) * OF_GAP
    room[i] = Math.min(fromRim, ofGap, AMPLE)
  }
  for (let i = 0; i < room.length; i++) room[i] = room[firstOf[i]]
  return room
}

/** Number of points per slice of work. */
const SLICE = 512

/** Tests whether point j is in front of point i and faces it. */
function isFacing(positions: ArrayLike<number>, smooth: Float64Array, i: number, j: number): boolean {
  if (i === j || dot(smooth, 3 * i, smooth, 3 * j) >= OPPOSED) return false
  let ahead = 0
  for (let k = 0; k < 3; k++) ahead += smooth[3 * i + k] * (positions[3 * j + k] - positions[3 * i + k])
  return ahead >= 0
}

/** Marks with 1 each first vertex on the border of the mesh or on an edge that folds back. */
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

/** Uniform grid of points with a hash table of cubes; each cube is a linked list. */
class PointGrid {
  readonly #positions: ArrayLike<number>
  readonly #side: number
  /** Integer coordinates of each vertex's cube. */
  readonly #cubes: Int32Array
  /** Hash table with linear probing: index + 1 of the last point of a cube, 0 = free. */
  readonly #last: Uint32Array
  /** Index + 1 of the previous point in the same cube, 0 = none. */
  readonly #before: Uint32Array
  readonly #count: number
  /** Cube of the last query, cached because consecutive queries are often in one cube. */
  readonly #middle = [NaN, NaN, NaN]
  /** Index + 1 of the last point of each occupied cube around it. */
  readonly #around = new Uint32Array(27)
  #near = 0

  constructor(positions: ArrayLike<number>, points: Uint32Array, side: number) {
    this.#positions = positions
    this.#side = side
    this.#count = points.length
    this.#cubes = Int32Array.from(positions, (coordinate) => Math.floor(coordinate / side))
    this.#last = new Uint32Array(2 ** Math.ceil(Math.log2(2 * points.length + 2)))
    this.#before = new Uint32Array(positions.length / 3)
    for (let k = 0; k < points.length; k++) {
      const i = points[k]
      const slot = this.#slotOf(this.#cubes[3 * i], this.#cubes[3 * i + 1], this.#cubes[3 * i + 2])
      this.#before[i] = this.#last[slot]
      this.#last[slot] = i + 1
    }
  }

  /** Lists all points, cube by cube. */
  points(): Uint32Array {
    const all = new Uint32Array(this.#count)
    let count = 0
    for (let slot = 0; slot < this.#last.length; slot++) {
      for (let next = this.#last[slot]; next > 0; next = this.#before[next - 1]) all[count++] = next - 1
    }
    return all
  }

  /** Returns the distance to the nearest point that meets a condition, or Infinity if there is none within the side of a cube. */
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

  /** Collects the occupied cubes in the 3 x 3 x 3 neighbourhood of a cube. */
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

  /** Returns the slot of a cube, or a free slot if the cube has no points. */
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
