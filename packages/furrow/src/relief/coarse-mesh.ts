/** Mesh to subdivide, in its rest pose. */
export interface CoarseMesh {
  /** Packed xyz per vertex, metres. */
  positions: ArrayLike<number>
  /** Packed uv per vertex: texture coordinates of the layers' maps. */
  uvs: ArrayLike<number>
  /** Three vertex indices per triangle. */
  triangles: ArrayLike<number>
}
