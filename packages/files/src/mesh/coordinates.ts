import type { Material, Primitive, TextureInfo } from '@gltf-transform/core'
import { KHRTextureTransform, type Transform } from '@gltf-transform/extensions'
import { Matrix3, Vector2 } from 'three'

/**
 * Reads the texture coordinates that renderers use for wrinkles: those of the material's normal map with its KHR_texture_transform, or
 * TEXCOORD_0 without a normal map. Exception: if only the base colour's transform decodes quantised coordinates, it is used, because
 * packing adds a normal map with this transform.
 *
 * @param vertices indices of the vertices to read.
 * @param out u and v of each vertex.
 */
export function readCoordinates(
  primitive: Primitive,
  material: Material,
  vertices: Uint32Array,
  out: Float32Array,
): void {
  const info = material.getNormalTextureInfo() ?? quantisedInfo(primitive, material)
  const transform = info?.getExtension<Transform>(KHRTextureTransform.EXTENSION_NAME)
  const channel = transform?.getTexCoord() ?? info?.getTexCoord() ?? 0
  const accessor = primitive.getAttribute(`TEXCOORD_${channel}`) ?? primitive.getAttribute('TEXCOORD_0')!
  const matrix = transform && matrixOf(transform)
  const uv = new Vector2()
  const element: number[] = []
  for (let i = 0; i < vertices.length; i++) {
    uv.fromArray(accessor.getElement(vertices[i], element))
    if (matrix) uv.applyMatrix3(matrix)
    uv.toArray(out, 2 * i)
  }
}

/** Same rule as `quantisedCoordinates`, on a decoded document. */
function quantisedInfo(primitive: Primitive, material: Material): TextureInfo | null {
  const info = material.getBaseColorTextureInfo()
  const transform = info?.getExtension<Transform>(KHRTextureTransform.EXTENSION_NAME)
  if (!transform) return null
  const channel = transform.getTexCoord() ?? info!.getTexCoord()
  const array = primitive.getAttribute(`TEXCOORD_${channel}`)?.getArray()
  return array && !(array instanceof Float32Array) ? info : null
}

/** Scales, rotates clockwise, then translates (KHR_texture_transform). `Matrix3.setUvTransform` cannot be used: it scales last. */
function matrixOf(transform: Transform): Matrix3 {
  const matrix = new Matrix3().makeTranslation(...transform.getOffset())
  matrix.multiply(new Matrix3().makeRotation(-transform.getRotation()))
  return matrix.multiply(new Matrix3().makeScale(...transform.getScale()))
}
