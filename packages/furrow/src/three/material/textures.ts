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
 * Creates a texture of areas: one channel, filtered, clamped to the edge as in the reference. No mipmaps: areas are smooth, and mipmaps
 * would bleed across UV islands.
 */
export function areaTexture(areas: ImageArray): DataArrayTexture {
  const texture = new DataArrayTexture(areas.data, areas.width, areas.height, areas.depth)
  texture.format = RedFormat
  texture.minFilter = LinearFilter
  return finish(texture)
}

const FORMATS = { 1: RedFormat, 2: RGFormat, 4: RGBAFormat } as const

/**
 * Creates a mipmapped texture of layer maps with one, two or four channels.
 *
 * @param anisotropy anisotropy of the base map, so that both blur alike at grazing angles.
 * @param colorSpace `SRGBColorSpace` for colours that are decoded when sampled, default none.
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
 * Creates a normal map of one flat texel. Half floats, because no byte is exactly 0.5 and skin without wrinkles must look unchanged.
 *
 * @param map map whose UV channel and transform are copied; null for the default.
 */
export function flatNormalTexture(map: Texture | null): DataTexture {
  const [half, one] = [0.5, 1].map(DataUtils.toHalfFloat)
  const texture = new DataTexture(Uint16Array.of(half, half, one, one), 1, 1, RGBAFormat, HalfFloatType)
  // The composed map inherits the wrapping, and must repeat as layers do.
  texture.wrapS = texture.wrapT = RepeatWrapping
  // The composed map is drawn with the same shader. On WebGPU the shader of an unfiltered texture would load level 0 only.
  texture.magFilter = LinearFilter
  texture.minFilter = LinearMipmapLinearFilter
  if (map) {
    texture.channel = map.channel
    texture.rotation = map.rotation
    for (const key of ['offset', 'repeat', 'center'] as const) texture[key].copy(map[key])
  }
  texture.needsUpdate = true
  return texture
}

function finish(texture: DataArrayTexture): DataArrayTexture {
  texture.magFilter = LinearFilter
  texture.wrapS = ClampToEdgeWrapping
  texture.wrapT = ClampToEdgeWrapping
  texture.needsUpdate = true
  return texture
}
