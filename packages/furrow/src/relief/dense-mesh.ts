/**
 * A mesh whose triangles have been split. Each vertex lies in a triangle of the coarse mesh: it follows that as it deforms, so that
 * neither blendshapes nor skinning are needed for it. Vertices that meet at a seam of the texture have equal `parents`, `weights` and
 * `uvs`, to the bit: computed from these alone, the surface has no cracks.
 */
export interface DenseMesh {
  /** Number of vertices; the coarse mesh's own come first. */
  count: number
  /** Three vertices each. */
  triangles: Uint32Array
  /** The triangles of coarser versions of the surface, of some of the same vertices. */
  coarser: Uint32Array[]
  /** Three vertices of the coarse mesh for each vertex, each the first at its position: for the surface. */
  parents: Uint32Array
  /** The same three corners as the triangle itself has them: for what differs at seams, such as shading normals and texture coordinates. */
  corners: Uint32Array
  /** Barycentric coordinates for the three, multiples of a power of two; their sum is 1. */
  weights: Float32Array
  /** Texture coordinates at which heights are read, two pairs: those of both sides of a seam, whose mean is the height there. */
  uvs: Float32Array
  /** Of each vertex of the coarse mesh the first one at its position. */
  firstOf: Uint32Array
  /** Length of the edges that was aimed at, in metres: longer than asked for where the budget would not do. */
  edge: number
}

/** Numbers in a typed array that grows. */
class Numbers<T extends Float32Array | Uint32Array> {
  #array: T
  #length = 0

  constructor(empty: T) {
    this.#array = empty
  }

  push(value: number): void {
    if (this.#length === this.#array.length) {
      const larger = new (this.#array.constructor as new (length: number) => T)(2 * this.#length + 1024)
      larger.set(this.#array)
      this.#array = larger
    }
    this.#array[this.#length++] = value
  }

  get all(): T {
    return this.#array.slice(0, this.#length) as T
  }
}

/** A dense mesh while it grows. */
export class DenseBuilder {
  count = 0
  readonly #parents = new Numbers(new Uint32Array())
  readonly #corners = new Numbers(new Uint32Array())
  readonly #weights = new Numbers(new Float32Array())
  readonly #uvs = new Numbers(new Float32Array())
  readonly #firstOf: Uint32Array
  readonly #versions: Numbers<Uint32Array>[]

  /**
   * @param firstOf of each coarse vertex the first one at its position.
   * @param versions of the surface.
   */
  constructor(firstOf: Uint32Array, versions: number) {
    this.#firstOf = firstOf
    this.#versions = Array.from({ length: versions }, () => new Numbers(new Uint32Array()))
  }

  /** Adds a vertex, by its corners, its weights and two pairs of texture coordinates, and returns its index. */
  addVertex(
    corners: readonly [number, number, number],
    weights: readonly [number, number, number],
    uvs: readonly [number, number, number, number],
  ): number {
    for (let k = 0; k < 3; k++) {
      this.#corners.push(corners[k])
      this.#parents.push(this.#firstOf[corners[k]])
      this.#weights.push(weights[k])
    }
    for (let k = 0; k < 4; k++) this.#uvs.push(uvs[k])
    return this.count++
  }

  addTriangle(version: number, a: number, b: number, c: number): void {
    const triangles = this.#versions[version]
    triangles.push(a)
    triangles.push(b)
    triangles.push(c)
  }

  finish(edge: number): DenseMesh {
    const [triangles, ...coarser] = this.#versions.map(({ all }) => all)
    return {
      count: this.count,
      triangles,
      coarser,
      parents: this.#parents.all,
      corners: this.#corners.all,
      weights: this.#weights.all,
      uvs: this.#uvs.all,
      firstOf: this.#firstOf,
      edge,
    }
  }
}
