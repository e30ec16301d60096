import { BufferAttribute, BufferGeometry } from 'three'
import { MeshBVH, type SerializedBVH } from 'three-mesh-bvh'

/**
 * A bounding volume hierarchy over triangles, which keep their order.
 *
 * @param positions x, y and z of each vertex; kept, and `refit` follows when they change.
 */
export function hierarchyOf(positions: Float32Array, indices: Uint32Array): MeshBVH {
  return new MeshBVH(geometryOf(positions, indices), { indirect: true })
}

/** One that was made of the same triangles before, for other positions of their vertices. */
export function hierarchyAgain(made: SerializedBVH, positions: Float32Array, indices: Uint32Array): MeshBVH {
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
