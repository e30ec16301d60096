import { BufferAttribute, BufferGeometry } from 'three'
import { MeshBVH } from 'three-mesh-bvh'

/**
 * A bounding volume hierarchy over triangles, which keep their order.
 *
 * @param positions x, y and z of each vertex; kept, and `refit` follows when they change.
 */
export function hierarchyOf(positions: Float32Array, indices: Uint32Array): MeshBVH {
  const geometry = new BufferGeometry()
  geometry.setAttribute('position', new BufferAttribute(positions, 3))
  geometry.setIndex(new BufferAttribute(indices, 1))
  return new MeshBVH(geometry, { indirect: true })
}
