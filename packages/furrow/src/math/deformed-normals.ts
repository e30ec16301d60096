/** A mesh at rest. Nothing is changed or kept but what is needed of it. */
export interface RestMesh {
  /** x, y and z of each vertex. */
  positions: ArrayLike<number>
  /** Of length 1, as authored. */
  normals: ArrayLike<number>
  /** Three vertices for each triangle. */
  triangles: ArrayLike<number>
}

/** Squared length of a sum of normals below which a vertex has no direction. */
export const NO_DIRECTION = 1e-24

/** Cosine of a turn below which it is turned right round, for which there is no shortest turn. */
export const TURNED_ROUND = -0.9999

/** Numbers the places of a mesh: vertices at one position, at rest, share one. */
export function placesOf(positions: ArrayLike<number>): { places: Uint32Array; count: number } {
  const numbers = new Map<string, number>()
  const places = new Uint32Array(positions.length / 3)
  for (let i = 0; i < places.length; i++) {
    const key = `${positions[3 * i]} ${positions[3 * i + 1]} ${positions[3 * i + 2]}`
    if (!numbers.has(key)) numbers.set(key, numbers.size)
    places[i] = numbers.get(key)!
  }
  return { places, count: numbers.size }
}

/**
 * Sums the normals of the triangles round each place, each as long as twice the triangle's surface.
 *
 * @param sums takes x, y and z of each place.
 * @param places of `placesOf`.
 */
export function sumNormals(
  sums: Float64Array,
  positions: ArrayLike<number>,
  triangles: ArrayLike<number>,
  places: Uint32Array,
): void {
  sums.fill(0)
  for (let t = 0; t + 2 < triangles.length; t += 3) {
    const a = 3 * triangles[t]
    const b = 3 * triangles[t + 1]
    const c = 3 * triangles[t + 2]
    const ux = positions[b] - positions[a]
    const uy = positions[b + 1] - positions[a + 1]
    const uz = positions[b + 2] - positions[a + 2]
    const vx = positions[c] - positions[a]
    const vy = positions[c + 1] - positions[a + 1]
    const vz = positions[c + 2] - positions[a + 2]
    for (let k = 0; k < 3; k++) {
      const place = 3 * places[triangles[t + k]]
      sums[place] += uy * vz - uz * vy
      sums[place + 1] += uz * vx - ux * vz
      sums[place + 2] += ux * vy - uy * vx
    }
  }
}

/** Turns what a morph target adds to positions into what it adds to normals. */
export function normalChanges(mesh: RestMesh): (offsets: ArrayLike<number>) => Float32Array {
  const positions = Float32Array.from(mesh.positions)
  const normals = Float32Array.from(mesh.normals)
  const deformed = new DeformedNormals(mesh)
  const turned = new Float32Array(normals.length)
  return (offsets) => {
    deformed.update(
      positions.map((value, i) => value + offsets[i]),
      turned,
    )
    return turned.map((value, i) => value - normals[i])
  }
}

/**
 * Shading normals of a mesh that something deforms. Vertices at one place share one direction, the sum of the normals of the triangles
 * round it by their areas, so that neither seams of the texture nor hard edges open; each authored normal is turned as that
 * direction turns from rest (by the shortest turn), so that what was authored stays. Nothing is allocated by the updates.
 */
export class DeformedNormals {
  readonly #rest: Float32Array
  readonly #triangles: Uint32Array
  /** For each vertex the number of its place. */
  readonly #places: Uint32Array
  /** Directions of all places, at rest and now. */
  readonly #from: Float64Array
  readonly #to: Float64Array

  constructor({ positions, normals, triangles }: RestMesh) {
    this.#rest = Float32Array.from(normals)
    this.#triangles = Uint32Array.from(triangles)
    const { places, count } = placesOf(positions)
    this.#places = places
    this.#from = new Float64Array(3 * count)
    this.#to = new Float64Array(3 * count)
    sumNormals(this.#from, positions, this.#triangles, places)
  }

  /**
   * Normals of the mesh as it is now; where a vertex has no direction, at rest or now, the authored one.
   *
   * @param positions of all vertices now.
   * @param normals takes x, y and z of each, of length 1.
   */
  update(positions: ArrayLike<number>, normals: Float32Array): void {
    sumNormals(this.#to, positions, this.#triangles, this.#places)
    normals.set(this.#rest)
    for (let i = 0; i < this.#places.length; i++) this.#turn(normals, 3 * i, 3 * this.#places[i])
  }

  /**
   * Turns other directions at the vertices as the last update turned the normals, e.g. tangents.
   *
   * @param directions x, y and z every `stride` numbers; changed.
   */
  turn(directions: Float32Array, stride: number): void {
    for (let i = 0; i < this.#places.length; i++) this.#turn(directions, stride * i, 3 * this.#places[i])
  }

  /** The shortest turn from one direction to another, by Rodrigues' formula: d c + (a x d) + a (a . d) / (1 + c), a = from x to. */
  #turn(out: Float32Array, at: number, place: number): void {
    const from = this.#from
    const to = this.#to
    const fromLength = from[place] ** 2 + from[place + 1] ** 2 + from[place + 2] ** 2
    const toLength = to[place] ** 2 + to[place + 1] ** 2 + to[place + 2] ** 2
    if (!(fromLength > NO_DIRECTION && toLength > NO_DIRECTION)) return
    const scale = 1 / Math.sqrt(fromLength * toLength)
    const cosine =
      scale * (from[place] * to[place] + from[place + 1] * to[place + 1] + from[place + 2] * to[place + 2])
    if (cosine < TURNED_ROUND) return
    const ax = scale * (from[place + 1] * to[place + 2] - from[place + 2] * to[place + 1])
    const ay = scale * (from[place + 2] * to[place] - from[place] * to[place + 2])
    const az = scale * (from[place] * to[place + 1] - from[place + 1] * to[place])
    const x = out[at]
    const y = out[at + 1]
    const z = out[at + 2]
    const along = (ax * x + ay * y + az * z) / (1 + cosine)
    out[at] = x * cosine + (ay * z - az * y) + ax * along
    out[at + 1] = y * cosine + (az * x - ax * z) + ay * along
    out[at + 2] = z * cosine + (ax * y - ay * x) + az * along
  }
}
