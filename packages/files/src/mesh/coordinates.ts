import type { Material, Primitive, TextureInfo } from '@gltf-transform/core'
import { KHRTextureTransform, type Transform } from '@gltf-transform/extensions'
import { Matrix3, Vector2 } from 'three'

/**
 * Reads the texture coordinates that renderers use for wrinkles. These are the coordinates of the material's normal
 * map, with its KHR_texture_transform. A material without a normal map uses TEXCOORD_0, with one exception. If the
 * transform of its base colour decodes quantised coordinates, this transform applies, because packing adds a normal map
 * with the same transform.
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

/** Applies the rule of `quantisedCoordinates` to a decoded document. */
function quantisedInfo(primitive: Primitive, material: Material): TextureInfo | null {
  const info = material.getBaseColorTextureInfo()
  const transform = info?.getExtension<Transform>(KHRTextureTransform.EXTENSION_NAME)
  if (!transform) return null
  const channel = transform.getTexCoord() ?? info!.getTexCoord()
  const array = primitive.getAttribute(`TEXCOORD_${channel}`)?.getArray()
  return array && !(array instanceof Float32Array) ? info : null
}

/**
 * Returns the matrix of KHR_texture_transform: it scales, then rotates clockwise, then translates.
 * `Matrix3.setUvTransform` scales last.
 */
function matrixOf(transform: Transform): Matrix3 {
  const matrix = new Matrix3().makeTranslation(...transform.getOffset())
  matrix.multiply(new Matrix3().makeRotation(-transform.getRotation()))
  return matrix.multiply(new Matrix3().makeScale(...transform.getScale()))
}
