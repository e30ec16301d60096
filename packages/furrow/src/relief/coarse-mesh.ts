/** Triangle mesh in its rest pose, before subdivision. */
export interface CoarseMesh {
  /** Packed xyz per vertex, in metres. */
  positions: ArrayLike<number>
  /** Packed uv per vertex: texture coordinates of the height maps. */
  uvs: ArrayLike<number>
  /** Three vertex indices per triangle. */
  triangles: ArrayLike<number>
}
