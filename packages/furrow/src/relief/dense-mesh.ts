/**
 * A subdivided mesh. Each vertex follows a triangle of the coarse mesh, so it needs no blendshapes or skinning. Vertices at a
 * texture seam have bit-identical `parents`, `weights` and `uvs`; a surface computed from these has no cracks.
 */
export interface DenseMesh {
  /** Number of vertices. The vertices of the coarse mesh come first. */
  count: number
  /** Three vertex indices per triangle. */
  triangles: Uint32Array
  /** Triangles of coarser versions of the surface. Each version uses a subset of the vertices. */
  coarser: Uint32Array[]
  /** Three coarse vertices per vertex, whose positions are interpolated. Of several coarse vertices at one position, the first is used. */
  parents: Uint32Array
  /** Corners of the coarse triangle, for attributes that differ at seams, such as shading normals and texture coordinates. */
  corners: Uint32Array
  /** Barycentric coordinates of the three corners, multiples of a power of two; the sum is 1. */
  weights: Float32Array
  /** Two pairs of texture coordinates, one per side of a seam. A vertex is displaced by the mean of the heights sampled at both. */
  uvs: Float32Array
  /** Maps each coarse vertex to the first coarse vertex at the same position. */
  firstOf: Uint32Array
  /** Target edge length in metres, increased to fit the budget. */
  edge: number
}

/** Growing typed array. */
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

/** Collects the vertices and triangles of a dense mesh. */
export class DenseBuilder {
  count = 0
  readonly #parents = new Numbers(new Uint32Array())
  readonly #corners = new Numbers(new Uint32Array())
  readonly #weights = new Numbers(new Float32Array())
  readonly #uvs = new Numbers(new Float32Array())
  readonly #firstOf: Uint32Array
  readonly #versions: Numbers<Uint32Array>[]

  /**
   * @param firstOf maps each coarse vertex to the first coarse vertex at the same position.
   * @param versions number of versions of the surface.
   */
  constructor(firstOf: Uint32Array, versions: number) {
    this.#firstOf = firstOf
    this.#versions = Array.from({ length: versions }, () => new Numbers(new Uint32Array()))
  }

  /** Adds a vertex by its coarse corners, barycentric weights and two pairs of texture coordinates. Returns the vertex index. */
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
