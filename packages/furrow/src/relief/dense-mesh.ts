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
  /** Three vertices of the coarse mesh for each vertex, each the first at its position: for the surface. */
  parents: Uint32Array
  /** The same three corners as the triangle itself has them: for what differs at seams, such as shading normals and texture coordinates. */
  corners: Uint32Array
  /** Barycentric coordinates for the three, multiples of a power of two; their sum is 1. */
  weights: Float32Array
  /** Texture coordinates at which heights are read, two pairs: those of both sides of a seam, whose mean is the height there. */
  uvs: Float32Array
  /** Length of the edges that was aimed at, in metres: longer than asked for where the budget would not do. */
  edge: number
}

/** The vertices of a dense mesh while it grows. */
export class DenseVertices {
  readonly parents: number[] = []
  readonly corners: number[] = []
  readonly weights: number[] = []
  readonly uvs: number[] = []
  readonly #firstOf: Uint32Array

  /** @param firstOf of each coarse vertex, see `WeldedEdges`. */
  constructor(firstOf: Uint32Array) {
    this.#firstOf = firstOf
  }

  get count(): number {
    return this.corners.length / 3
  }

  /** Adds a vertex, and returns its index. */
  add(
    corners: readonly [number, number, number],
    weights: readonly [number, number, number],
    uvs: readonly [number, number, number, number],
  ): number {
    for (const corner of corners) {
      this.corners.push(corner)
      this.parents.push(this.#firstOf[corner])
    }
    this.weights.push(...weights)
    this.uvs.push(...uvs)
    return this.count - 1
  }
}
