import type { BakeSource } from 'furrow/author'
import { BufferAttribute, BufferGeometry, DoubleSide, FrontSide, Ray, Triangle, Vector3 } from 'three'
import { MeshBVH } from 'three-mesh-bvh'
import type { Surface } from './surface.ts'

/**
 * Builds a bounding volume hierarchy (three-mesh-bvh) of a surface, for ray casts. The hierarchy keeps `indices` and
 * reorders them.
 */
export function raySourceOf({ positions, normals, indices }: Surface): BakeSource {
  const geometry = new BufferGeometry()
  geometry.setAttribute('position', new BufferAttribute(positions, 3))
  geometry.setIndex(new BufferAttribute(indices, 1))
  const normalAttribute = normals && new BufferAttribute(normals, 3)
  const hierarchy = new MeshBVH(geometry)
  const ray = new Ray()
  const normal = new Vector3()
  return {
    closestHit(x, y, z, dx, dy, dz, far, hit) {
      ray.origin.set(x, y, z)
      ray.direction.set(dx, dy, dz)
      const found = hierarchy.raycastFirst(ray, FrontSide, 0, far)
      if (!found?.face || !found.barycoord) return false
      const { a, b, c } = found.face
      if (normalAttribute) {
        Triangle.getInterpolatedAttribute(normalAttribute, a, b, c, found.barycoord, normal).normalize()
      } else normal.copy(found.face.normal)
      hit[0] = found.distance
      normal.toArray(hit, 1)
      return true
    },
    anyHit(x, y, z, dx, dy, dz, far) {
      ray.origin.set(x, y, z)
      ray.direction.set(dx, dy, dz)
      return hierarchy.raycastFirst(ray, DoubleSide, 0, far) !== null
    },
  }
}
