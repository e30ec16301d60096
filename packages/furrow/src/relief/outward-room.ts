import type { CoarseMesh } from './coarse-mesh.ts'
import { smoothNormals } from './displaced.ts'

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
 * @param firstOf of each vertex the first one at its position, see `WeldedEdges`.
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
  const cell = Math.max(reach / OF_GAP, reach / FROM_RIM)
  const points = firstOf.reduce<number[]>((list, first, i) => {
    if (first === i) list.push(i)
    return list
  }, [])
  const grid = new PointGrid(positions, points, cell)
  const isRim = rims(triangles, smooth, firstOf)
  for (const i of points) {
    const limit = (value: number) => {
      room[i] = Math.min(room[i], value)
    }
    grid.visit(i, (j) => {
      const d = [0, 1, 2].map((axis) => positions[3 * j + axis] - positions[3 * i + axis])
      const distance = Math.hypot(...d)
      if (isRim[j]) limit(distance * FROM_RIM)
      const facing = dot(smooth, 3 * i, smooth, 3 * j)
      if (i !== j && facing < OPPOSED && dot(smooth, 3 * i, d, 0) >= 0) limit(distance * OF_GAP)
    })
  }
  for (let i = 0; i < room.length; i++) room[i] = room[firstOf[i]]
  return room
}

/** 1 for each first vertex on the border of the mesh, or on an edge that turns back. */
function rims(triangles: ArrayLike<number>, smooth: Float64Array, firstOf: Uint32Array): Uint8Array {
  const isRim = new Uint8Array(firstOf.length)
  const sides = new Map<number, number>()
  for (let k = 0; k + 2 < triangles.length; k += 3) {
    for (let corner = 0; corner < 3; corner++) {
      const [a, b] = [firstOf[triangles[k + corner]], firstOf[triangles[k + ((corner + 1) % 3)]]]
      const key = a < b ? a * firstOf.length + b : b * firstOf.length + a
      sides.set(key, (sides.get(key) ?? 0) + 1)
      if (dot(smooth, 3 * a, smooth, 3 * b) < OPPOSED) isRim[a] = isRim[b] = 1
    }
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
  readonly #cubes = new Map<string, number[]>()

  constructor(positions: ArrayLike<number>, points: readonly number[], cell: number) {
    this.#positions = positions
    this.#cell = cell
    for (const i of points) {
      const key = this.#cubeOf(i).join()
      const cube = this.#cubes.get(key)
      if (cube) cube.push(i)
      else this.#cubes.set(key, [i])
    }
  }

  /** Visits all points within a cube's side of a point, itself and some farther ones included. */
  visit(i: number, visit: (j: number) => void): void {
    const [x, y, z] = this.#cubeOf(i)
    for (let dx = -1; dx <= 1; dx++) {
      for (let dy = -1; dy <= 1; dy++) {
        for (let dz = -1; dz <= 1; dz++) {
          for (const j of this.#cubes.get(`${x + dx},${y + dy},${z + dz}`) ?? []) visit(j)
        }
      }
    }
  }

  #cubeOf(i: number): number[] {
    return [0, 1, 2].map((axis) => Math.floor(this.#positions[3 * i + axis] / this.#cell))
  }
}

function dot(a: ArrayLike<number>, i: number, b: ArrayLike<number>, j: number): number {
  return a[i] * b[j] + a[i + 1] * b[j + 1] + a[i + 2] * b[j + 2]
}
