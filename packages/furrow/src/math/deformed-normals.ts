import { triangleNormal } from './triangle.ts'
import { weldVertices } from './weld.ts'

/** Mesh in its rest pose. */
export interface RestMesh {
  /** Packed xyz per vertex. */
  positions: ArrayLike<number>
  /** Authored unit normal of each vertex, packed xyz. */
  normals: ArrayLike<number>
  /** Three vertex indices per triangle. */
  triangles: ArrayLike<number>
}

/** Squared length below which a sum of normals has no meaningful direction. */
export const NO_DIRECTION = 1e-24

/** Cosine of an angle close to 180 degrees. Vectors with a smaller cosine are opposite, so the shortest arc between them is not unique. */
export const HALF_TURN = -0.9999

/** Scratch vector, reused so that updates allocate nothing. */
const normal = new Float64Array(3)

/**
 * Sums the normals of the triangles around each welded point, i.e. around all vertices at one position. Each unit normal is weighted by twice the
 * area of its triangle.
 *
 * @param sums receives one vector per welded point, packed xyz.
 * @param positions packed xyz per vertex.
 * @param pointOf index of the welded point of each vertex, from `weldVertices`.
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

/** Returns a function that converts position deltas of a morph target to normal deltas. Deltas are packed xyz per vertex. */
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
 * Computes the shading normals of a deforming mesh by rotating its authored normals. Vertices with the same rest position form a welded point.
 * The direction of a point is the area-weighted sum of the normals of its triangles. All authored normals at a point are rotated by the same arc:
 * the shortest one from the point's direction in the rest pose to its direction in the current pose. Lighting therefore stays continuous at
 * seams. Updates allocate nothing.
 */
export class DeformedNormals {
  readonly #rest: Float32Array
  readonly #triangles: Uint32Array
  /** For each vertex, the index of its welded point. */
  readonly #pointOf: Uint32Array
  /** Directions of all welded points in the rest pose, packed xyz. */
  readonly #from: Float64Array
  /** Directions of all welded points in the current pose, packed xyz. */
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
   * Computes the normals of the mesh in its current pose. Vertices keep their authored normal if the direction of their point is undefined, or
   * has turned by almost 180 degrees.
   *
   * @param positions current positions, packed xyz per vertex.
   * @param normals receives the unit normals, packed xyz per vertex.
   */
  update(positions: ArrayLike<number>, normals: Float32Array): void {
    sumNormals(this.#to, positions, this.#triangles, this.#pointOf)
    normals.set(this.#rest)
    for (let i = 0; i < this.#pointOf.length; i++) this.#rotate(normals, 3 * i, 3 * this.#pointOf[i])
  }

  /**
   * Rotates other vectors of the vertices, such as tangents, in place. Applies the rotations that the last `update` applied to the normals.
   *
   * @param directions one vector per vertex: the first three of every `stride` numbers.
   */
  rotate(directions: Float32Array, stride: number): void {
    for (let i = 0; i < this.#pointOf.length; i++) this.#rotate(directions, stride * i, 3 * this.#pointOf[i])
  }

  /**
   * Rotates a vector `d` by the shortest arc between two unit directions of a welded point: `from` in the rest pose, and `to` in the current
   * pose. Rodrigues' formula is `c * d + cross(a, d) + a * dot(a, d) / (1 + c)`, where `a = cross(from, to)` and `c = dot(from, to)`.
   */
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
