import type { BakeTarget } from 'furrow/author'
import { BufferAttribute, BufferGeometry, DoubleSide, FrontSide, Ray } from 'three'
import { MeshBVH } from 'three-mesh-bvh'
import type { Surface } from './read-meshes.ts'

/** Makes a surface ready for rays by a hierarchy of boxes (three-mesh-bvh). The index array is kept and sorted. */
export function targetOf({ positions, normals, indices }: Surface): BakeTarget {
  const geometry = new BufferGeometry()
  geometry.setAttribute('position', new BufferAttribute(positions, 3))
  geometry.setIndex(new BufferAttribute(indices, 1))
  const hierarchy = new MeshBVH(geometry)
  const ray = new Ray()
  return {
    nearest(x, y, z, dx, dy, dz, far, hit) {
      ray.origin.set(x, y, z)
      ray.direction.set(dx, dy, dz)
      const found = hierarchy.raycastFirst(ray, FrontSide, 0, far)
      if (!found?.face) return false
      hit[0] = found.distance
      const { a, b, c } = found.face
      if (normals) blend(positions, normals, a, b, c, found.point, hit)
      else hit.set([found.face.normal.x, found.face.normal.y, found.face.normal.z], 1)
      return true
    },
    blocked(x, y, z, dx, dy, dz, far) {
      ray.origin.set(x, y, z)
      ray.direction.set(dx, dy, dz)
      return hierarchy.raycastFirst(ray, DoubleSide, 0, far) !== null
    },
  }
}

/** The shading normal at a point of a triangle, by its barycentric coordinates: shares of the triangle's area. */
function blend(
  positions: Float32Array,
  normals: Float32Array,
  a: number,
  b: number,
  c: number,
  { x, y, z }: { x: number; y: number; z: number },
  hit: Float64Array,
): void {
  const [ax, ay, az] = [positions[3 * a], positions[3 * a + 1], positions[3 * a + 2]]
  const [ex, ey, ez] = [positions[3 * b] - ax, positions[3 * b + 1] - ay, positions[3 * b + 2] - az]
  const [fx, fy, fz] = [positions[3 * c] - ax, positions[3 * c + 1] - ay, positions[3 * c + 2] - az]
  const [px, py, pz] = [x - ax, y - ay, z - az]
  const ee = ex * ex + ey * ey + ez * ez
  const ef = ex * fx + ey * fy + ez * fz
  const ff = fx * fx + fy * fy + fz * fz
  const pe = px * ex + py * ey + pz * ez
  const pf = px * fx + py * fy + pz * fz
  const det = ee * ff - ef * ef || 1
  const wb = (ff * pe - ef * pf) / det
  const wc = (ee * pf - ef * pe) / det
  const wa = 1 - wb - wc
  let length = 0
  for (let k = 0; k < 3; k++) {
    const value = wa * normals[3 * a + k] + wb * normals[3 * b + k] + wc * normals[3 * c + k]
    hit[1 + k] = value
    length += value * value
  }
  for (let k = 1; k < 4; k++) hit[k] /= Math.sqrt(length) || 1
}
