/** Original mesh, at rest, before its triangles are split. */
export interface CoarseMesh {
  /** x, y and z of each vertex, in metres. */
  positions: ArrayLike<number>
  /** u and v of each vertex, for the layers' maps. */
  uvs: ArrayLike<number>
  /** Three vertex indices per triangle. */
  triangles: ArrayLike<number>
}
