import {
  ClampToEdgeWrapping,
  type ColorSpace,
  DataArrayTexture,
  DataTexture,
  DataUtils,
  HalfFloatType,
  LinearFilter,
  LinearMipmapLinearFilter,
  NoColorSpace,
  RedFormat,
  RepeatWrapping,
  RGBAFormat,
  RGFormat,
  type Texture,
} from 'three'
import type { ImageArray } from '../../core/image-array.ts'

/**
 * Creates a texture array of areas, with one channel per slice. It has no mipmaps: areas are smooth enough without them, and in mipmaps areas
 * would bleed across the borders of UV islands.
 */
export function areaTexture(areas: ImageArray): DataArrayTexture {
  const texture = new DataArrayTexture(areas.data, areas.width, areas.height, areas.depth)
  texture.format = RedFormat
  texture.minFilter = LinearFilter
  return finish(texture)
}

const FORMATS = { 1: RedFormat, 2: RGFormat, 4: RGBAFormat } as const

/**
 * Creates a mipmapped texture array of layer maps with one, two or four channels.
 *
 * @param anisotropy anisotropy of the material's normal map, so that wrinkles and normal map blur equally at grazing angles.
 * @param colorSpace `SRGBColorSpace` for colours, default `NoColorSpace`.
 */
export function mapTexture(
  maps: ImageArray,
  anisotropy: number,
  colorSpace: ColorSpace = NoColorSpace,
): DataArrayTexture {
  const texture = new DataArrayTexture(maps.data, maps.width, maps.height, maps.depth)
  texture.format = FORMATS[maps.channels]
  texture.colorSpace = colorSpace
  texture.minFilter = LinearMipmapLinearFilter
  texture.generateMipmaps = true
  texture.anisotropy = anisotropy
  return finish(texture)
}

/**
 * Creates a normal map of one flat texel. The texel has half floats, because no byte is exactly 0.5. With bytes, a material would look slightly
 * different than without a normal map.
 *
 * @param map map whose UV channel and transform are copied; null for channel 0 without a transform.
 */
export function flatNormalTexture(map: Texture | null): DataTexture {
  const [half, one] = [0.5, 1].map(DataUtils.toHalfFloat)
  const texture = new DataTexture(Uint16Array.of(half, half, one, one), 1, 1, RGBAFormat, HalfFloatType)
  // A composed normal map copies this wrapping. It must repeat, because the other modes wrap the texture coordinates of layers into 0..1.
  texture.wrapS = texture.wrapT = RepeatWrapping
  // On WebGPU, the shader of the composed normal map would read only mip level 0 if this texture were not filtered.
  texture.magFilter = LinearFilter
  texture.minFilter = LinearMipmapLinearFilter
  if (map) copyUvTransform(texture, map)
  texture.needsUpdate = true
  return texture
}

/** Sets the UV channel and the UV transform of a texture to those of another texture. */
export function copyUvTransform(texture: Texture, from: Texture): void {
  texture.channel = from.channel
  texture.rotation = from.rotation
  texture.matrixAutoUpdate = from.matrixAutoUpdate
  for (const key of ['offset', 'repeat', 'center'] as const) texture[key].copy(from[key])
  texture.matrix.copy(from.matrix)
}

function finish(texture: DataArrayTexture): DataArrayTexture {
  texture.magFilter = LinearFilter
  texture.wrapS = ClampToEdgeWrapping
  texture.wrapT = ClampToEdgeWrapping
  texture.needsUpdate = true
  return texture
}
