/**
 * A subdivided mesh. Each vertex is interpolated on a triangle of the deformed coarse mesh, so the dense mesh itself needs no blendshapes or
 * skinning. Where a texture seam duplicates a vertex, the copies have exactly the same `parents`, `weights` and `uvs`. A surface that is
 * computed from these arrays therefore has no cracks.
 */
export interface DenseMesh {
  /** Number of vertices. The vertices of the coarse mesh come first. */
  count: number
  /** Three vertex indices per triangle. */
  triangles: Uint32Array
  /** Triangles of each coarser version of the mesh. A version uses only some of the vertices. */
  coarser: Uint32Array[]
  /**
   * For each vertex, the three coarse vertices whose positions are interpolated. Where a seam duplicates a coarse vertex, the copy with the
   * lowest index is stored (see `firstOf`).
   */
  parents: Uint32Array
  /**
   * For each vertex, the three coarse vertices whose shading normals and texture coordinates are interpolated. At a seam, these may differ
   * from `parents`, because coarse vertices at the same position have different normals or texture coordinates.
   */
  corners: Uint32Array
  /** Three weights per vertex for the interpolation: barycentric coordinates whose sum is 1. */
  weights: Float32Array
  /** Two pairs of texture coordinates per vertex, which differ at a seam. A vertex is displaced by the mean of the heights at both. */
  uvs: Float32Array
  /** Maps each coarse vertex to the coarse vertex with the lowest index at the same position. */
  firstOf: Uint32Array
  /** Target edge length in metres. It may be longer than requested, to limit the number of triangles. */
  edge: number
}

/** Typed array that grows when numbers are added. */
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
   * @param firstOf maps each coarse vertex to the coarse vertex with the lowest index at the same position.
   * @param versions number of versions of the mesh, including the finest version.
   */
  constructor(firstOf: Uint32Array, versions: number) {
    this.#firstOf = firstOf
    this.#versions = Array.from({ length: versions }, () => new Numbers(new Uint32Array()))
  }

  /** Adds a vertex with its three corners, three weights and two pairs of texture coordinates. Returns its index. */
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
