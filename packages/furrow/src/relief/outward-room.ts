import type { CoarseMesh } from './coarse-mesh.ts'
import { smoothNormals } from './displaced.ts'
import { nextCorner } from './welded-edges.ts'

/** Of the gap between two surfaces, how much each may fill. */
const OF_GAP = 0.4

/** Metres outwards per metre from a rim. */
const FROM_RIM = 0.25

/** Metres outwards at most, where nothing is in the way: more than any skin folds. */
const AMPLE = 0.01

/** Cosine of the angle between two normals beyond which surfaces face each other, or an edge is a rim. */
const OPPOSED = -0.2

/**
 * How far a surface may bulge at each vertex without touching another part of it. Lips face each other: each may fill less than half of
 * the gap. Rims, as those of lids, come to lie on others when the face moves: they do not bulge, and skin near them little.
 *
 * @param normals unit normals at rest.
 * @param firstOf of each vertex the first one at its position, see `firstVertices`.
 * @param reach metres within which other parts matter: the largest displacement.
 * @returns metres outwards, at each vertex.
 */
export function outwardRoom(
  { positions, triangles }: CoarseMesh,
  normals: ArrayLike<number>,
  firstOf: Uint32Array,
  reach: number,
): Float32Array {
  const room = new Float32Array(firstOf.length).fill(AMPLE)
  const smooth = smoothNormals(normals, firstOf)
  const isRim = rims(triangles, smooth, firstOf)
  const points = firstOf.filter((first, vertex) => first === vertex)
  // No farther than matters: a rim that leaves more than `reach`, a gap of which the part is more than `reach`.
  const grid = new PointGrid(positions, points, reach / OF_GAP)
  const rimGrid = new PointGrid(
    positions,
    points.filter((i) => isRim[i]),
    reach / FROM_RIM,
  )
  for (const i of points) {
    let least = AMPLE
    rimGrid.visit(i, (j) => {
      least = Math.min(least, distance(positions, i, j) * FROM_RIM)
    })
    grid.visit(i, (j) => {
      if (isFacing(positions, smooth, i, j)) least = Math.min(least, distance(positions, i, j) * OF_GAP)
    })
    room[i] = least
  }
  for (let i = 0; i < room.length; i++) room[i] = room[firstOf[i]]
  return room
}

/** Whether a point is in front of another one, and faces it. */
function isFacing(positions: ArrayLike<number>, smooth: Float64Array, i: number, j: number): boolean {
  if (i === j || dot(smooth, 3 * i, smooth, 3 * j) >= OPPOSED) return false
  let ahead = 0
  for (let k = 0; k < 3; k++) ahead += smooth[3 * i + k] * (positions[3 * j + k] - positions[3 * i + k])
  return ahead >= 0
}

function distance(positions: ArrayLike<number>, i: number, j: number): number {
  const x = positions[3 * j] - positions[3 * i]
  const y = positions[3 * j + 1] - positions[3 * i + 1]
  const z = positions[3 * j + 2] - positions[3 * i + 2]
  return Math.sqrt(x * x + y * y + z * z)
}

/** 1 for each first vertex on the border of the mesh, or on an edge that turns back. */
function rims(triangles: ArrayLike<number>, smooth: Float64Array, firstOf: Uint32Array): Uint8Array {
  const isRim = new Uint8Array(firstOf.length)
  const sides = new Map<number, number>()
  for (let corner = 0; corner < triangles.length - (triangles.length % 3); corner++) {
    const [a, b] = [firstOf[triangles[corner]], firstOf[triangles[nextCorner(corner)]]]
    const key = a < b ? a * firstOf.length + b : b * firstOf.length + a
    sides.set(key, (sides.get(key) ?? 0) + 1)
    if (dot(smooth, 3 * a, smooth, 3 * b) < OPPOSED) isRim[a] = isRim[b] = 1
  }
  for (const [key, count] of sides) {
    if (count === 1) isRim[key % firstOf.length] = isRim[Math.floor(key / firstOf.length)] = 1
  }
  return isRim
}

/** Points in cubes. */
class PointGrid {
  readonly #positions: ArrayLike<number>
  readonly #cell: number
  readonly #cubes = new Map<number, number[]>()

  constructor(positions: ArrayLike<number>, points: Uint32Array, cell: number) {
    this.#positions = positions
    this.#cell = cell
    for (const i of points) {
      const key = keyOf(this.#at(i, 0), this.#at(i, 1), this.#at(i, 2))
      const cube = this.#cubes.get(key)
      if (cube) cube.push(i)
      else this.#cubes.set(key, [i])
    }
  }

  /** Visits all points within a cube's side of a point, itself and some farther ones included. */
  visit(i: number, visit: (j: number) => void): void {
    const [x, y, z] = [this.#at(i, 0), this.#at(i, 1), this.#at(i, 2)]
    for (let dx = -1; dx <= 1; dx++) {
      for (let dy = -1; dy <= 1; dy++) {
        for (let dz = -1; dz <= 1; dz++) {
          const cube = this.#cubes.get(keyOf(x + dx, y + dy, z + dz))
          if (cube) for (const j of cube) visit(j)
        }
      }
    }
  }

  #at(i: number, axis: number): number {
    return Math.floor(this.#positions[3 * i + axis] / this.#cell)
  }
}

/** One number for a cube. Cubes far apart may have the same: that only costs time. */
function keyOf(x: number, y: number, z: number): number {
  return (x & 0xffff) + 0x10000 * (y & 0xffff) + 0x100000000 * (z & 0xffff)
}

function dot(a: ArrayLike<number>, i: number, b: ArrayLike<number>, j: number): number {
  return a[i] * b[j] + a[i + 1] * b[j + 1] + a[i + 2] * b[j + 2]
}
