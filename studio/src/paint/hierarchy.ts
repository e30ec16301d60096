import { BufferAttribute, BufferGeometry } from 'three'
import { MeshBVH, type SerializedBVH } from 'three-mesh-bvh'

/**
 * Builds a bounding volume hierarchy of triangles, without changing their order.
 *
 * @param positions packed xyz per vertex. Not copied: call `refit` after changes.
 */
export function buildHierarchy(positions: Float32Array, indices: Uint32Array): MeshBVH {
  return new MeshBVH(geometryOf(positions, indices), { indirect: true })
}

/** Restores a serialised hierarchy of the same triangles for other vertex positions. */
export function restoreHierarchy(
  made: SerializedBVH,
  positions: Float32Array,
  indices: Uint32Array,
): MeshBVH {
  const hierarchy = MeshBVH.deserialize(made, geometryOf(positions, indices), { setIndex: false })
  hierarchy.refit()
  return hierarchy
}

function geometryOf(positions: Float32Array, indices: Uint32Array): BufferGeometry {
  const geometry = new BufferGeometry()
  geometry.setAttribute('position', new BufferAttribute(positions, 3))
  geometry.setIndex(new BufferAttribute(indices, 1))
  return geometry
}
