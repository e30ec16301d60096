import { triangleNormal } from './triangle.ts'
import { weldVertices } from './weld.ts'

/** A mesh at rest; its arrays are copied. */
export interface RestMesh {
  /** x, y and z of each vertex. */
  positions: ArrayLike<number>
  /** Unit normal of each vertex, as authored. */
  normals: ArrayLike<number>
  /** Three vertices per triangle. */
  triangles: ArrayLike<number>
}

/** Squared length; shorter sums of normals have no usable direction. */
export const NO_DIRECTION = 1e-24

/** Rotations with a smaller cosine count as half a turn, whose axis is ambiguous. */
export const HALF_TURN = -0.9999

/** Scratch, so that updates allocate nothing. */
const normal = new Float64Array(3)

/**
 * Sums the normals of the triangles around each point, weighted by twice the area.
 *
 * @param sums receives xyz of each point.
 * @param pointOf point of each vertex, from `weldVertices`.
 */
export function sumNormals(
  sums: Float64Array,
  positions: ArrayLike<number>,
  triangles: ArrayLike<number>,
  pointOf: Uint32Array,
): void {
  sums.fill(0)
  for (let t = 0; t + 2 < triangles.length; t += 3) {
    triangleNormal(normal, positions, triangles[t], triangles[t + 1], triangles[t + 2])
    for (let k = 0; k < 3; k++) {
      const point = 3 * pointOf[triangles[t + k]]
      sums[point] += normal[0]
      sums[point + 1] += normal[1]
      sums[point + 2] += normal[2]
    }
  }
}

/** Returns a function that computes the normal deltas of a morph target from its position deltas; both have x, y and z per vertex. */
export function morphNormalDeltas(mesh: RestMesh): (offsets: ArrayLike<number>) => Float32Array {
  const positions = Float32Array.from(mesh.positions)
  const normals = Float32Array.from(mesh.normals)
  const deformed = new DeformedNormals(mesh)
  const morphed = new Float32Array(normals.length)
  return (offsets) => {
    deformed.update(
      positions.map((value, i) => value + offsets[i]),
      morphed,
    )
    return morphed.map((value, i) => value - normals[i])
  }
}

/**
 * Recomputes shading normals of a deforming mesh. At each position, the area-weighted normals of adjacent triangles give a direction, at
 * rest and now. The authored normals are rotated by the shortest arc between both, so that hard edges stay hard and seams stay closed.
 * Updates allocate nothing.
 */
export class DeformedNormals {
  readonly #rest: Float32Array
  readonly #triangles: Uint32Array
  /** Point index of each vertex; vertices at one position share a point. */
  readonly #pointOf: Uint32Array
  /** Unnormalised directions of all points, at rest and now. */
  readonly #from: Float64Array
  readonly #to: Float64Array

  constructor({ positions, normals, triangles }: RestMesh) {
    this.#rest = Float32Array.from(normals)
    this.#triangles = Uint32Array.from(triangles)
    const { pointOf, count } = weldVertices(positions)
    this.#pointOf = pointOf
    this.#from = new Float64Array(3 * count)
    this.#to = new Float64Array(3 * count)
    sumNormals(this.#from, positions, this.#triangles, pointOf)
  }

  /**
   * Computes the normals of the deformed mesh. A vertex without a direction, at rest or now, keeps its authored normal.
   *
   * @param positions current positions of all vertices.
   * @param normals receives the unit normals.
   */
  update(positions: ArrayLike<number>, normals: Float32Array): void {
    sumNormals(this.#to, positions, this.#triangles, this.#pointOf)
    normals.set(this.#rest)
    for (let i = 0; i < this.#pointOf.length; i++) this.#rotate(normals, 3 * i, 3 * this.#pointOf[i])
  }

  /**
   * Rotates other vertex directions, such as tangents, like the normals in the last update.
   *
   * @param directions xyz every `stride` numbers; modified.
   */
  rotate(directions: Float32Array, stride: number): void {
    for (let i = 0; i < this.#pointOf.length; i++) this.#rotate(directions, stride * i, 3 * this.#pointOf[i])
  }

  /** Rotates by the shortest arc between two directions (Rodrigues): d c + (a x d) + a (a . d) / (1 + c), where a = from x to. */
  #rotate(vectors: Float32Array, offset: number, point: number): void {
    const from = this.#from
    const to = this.#to
    const fromLength = from[point] ** 2 + from[point + 1] ** 2 + from[point + 2] ** 2
    const toLength = to[point] ** 2 + to[point + 1] ** 2 + to[point + 2] ** 2
    if (!(fromLength > NO_DIRECTION && toLength > NO_DIRECTION)) return
    const scale = 1 / Math.sqrt(fromLength * toLength)
    const cosine =
      scale * (from[point] * to[point] + from[point + 1] * to[point + 1] + from[point + 2] * to[point + 2])
    if (cosine < HALF_TURN) return
    const ax = scale * (from[point + 1] * to[point + 2] - from[point + 2] * to[point + 1])
    const ay = scale * (from[point + 2] * to[point] - from[point] * to[point + 2])
    const az = scale * (from[point] * to[point + 1] - from[point + 1] * to[point])
    const x = vectors[offset]
    const y = vectors[offset + 1]
    const z = vectors[offset + 2]
    const along = (ax * x + ay * y + az * z) / (1 + cosine)
    vectors[offset] = x * cosine + (ay * z - az * y) + ax * along
    vectors[offset + 1] = y * cosine + (az * x - ax * z) + ay * along
    vectors[offset + 2] = z * cosine + (ax * y - ay * x) + az * along
  }
}
