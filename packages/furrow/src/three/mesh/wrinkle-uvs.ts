import { type Material, type Mesh, type MeshStandardMaterial, Vector2 } from 'three'

/**
 * Computes the texture coordinates at which the maps of wrinkles are sampled. These are the coordinates of the normal map after its
 * `KHR_texture_transform`; without a normal map, the first UV set.
 *
 * @returns packed uv per vertex.
 */
export function wrinkleUvs({ geometry }: Mesh, material: Material): Float64Array {
  const { normalMap } = material as MeshStandardMaterial
  const attribute = geometry.getAttribute(normalMap?.channel ? `uv${normalMap.channel}` : 'uv')
  const uvs = new Float64Array(2 * attribute.count)
  const uv = new Vector2()
  normalMap?.updateMatrix()
  for (let i = 0; i < attribute.count; i++) {
    uv.fromBufferAttribute(attribute as never, i)
    if (normalMap) uv.applyMatrix3(normalMap.matrix)
    uvs[2 * i] = uv.x
    uvs[2 * i + 1] = uv.y
  }
  return uvs
}
