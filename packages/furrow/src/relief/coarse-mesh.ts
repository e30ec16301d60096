/** A mesh whose triangles are split, at rest. */
export interface CoarseMesh {
  /** x, y and z of each vertex, in metres. */
  positions: ArrayLike<number>
  /** Texture coordinates of the layers' maps, of each vertex. */
  uvs: ArrayLike<number>
  /** Three vertices each. */
  triangles: ArrayLike<number>
}
