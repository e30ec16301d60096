import type { Material, Primitive } from '@gltf-transform/core'
import { KHRTextureTransform, type Transform } from '@gltf-transform/extensions'

/**
 * Reads the texture coordinates at which renderers look for wrinkles: those of the material's normal map, with its
 * KHR_texture_transform; the first ones where it has no normal map.
 *
 * @param used the vertices that are wanted.
 * @param out u and v of each of them.
 */
export function readCoordinates(
  primitive: Primitive,
  material: Material,
  used: Uint32Array,
  out: Float32Array,
): void {
  const info = material.getNormalTextureInfo()
  const transform = info?.getExtension<Transform>(KHRTextureTransform.EXTENSION_NAME)
  const channel = transform?.getTexCoord() ?? info?.getTexCoord() ?? 0
  const accessor = primitive.getAttribute(`TEXCOORD_${channel}`) ?? primitive.getAttribute('TEXCOORD_0')!
  const matrix = transform ? matrixOf(transform) : undefined
  const element: number[] = []
  for (const [i, vertex] of used.entries()) {
    accessor.getElement(vertex, element)
    const [u, v] = element as [number, number]
    out[2 * i] = matrix ? matrix[0] * u + matrix[1] * v + matrix[2] : u
    out[2 * i + 1] = matrix ? matrix[3] * u + matrix[4] * v + matrix[5] : v
  }
}

/** Scaled, turned, then moved (KHR_texture_transform); rows of a 2 x 3 matrix. */
function matrixOf(transform: Transform): [number, number, number, number, number, number] {
  const [[x, y], [across, down]] = [transform.getOffset(), transform.getScale()]
  const [cosine, sine] = [Math.cos(transform.getRotation()), Math.sin(transform.getRotation())]
  return [cosine * across, sine * down, x, -sine * across, cosine * down, y]
}
