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
 * A texture of areas: one channel, filtered, without mipmaps (areas are smooth already, and mipmaps would bleed across UV islands).
 * Edges are clamped, as in the reference.
 */
export function areaTexture(areas: ImageArray): DataArrayTexture {
  const texture = new DataArrayTexture(areas.data, areas.width, areas.height, areas.depth)
  texture.format = RedFormat
  texture.minFilter = LinearFilter
  return finish(texture)
}

const FORMATS = { 1: RedFormat, 2: RGFormat, 4: RGBAFormat } as const

/**
 * A texture of layers' maps, with one channel, two or four, filtered with mipmaps.
 *
 * @param anisotropy that of the map they are mixed with, so that both blur alike at grazing angles.
 * @param colorSpace `SRGBColorSpace` for colours to be decoded when sampled; none by default.
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
 * A normal map of one flat texel, for a material that has none. In half floats, since no byte is exactly 0.5: skin without wrinkles
 * must look as it did before.
 *
 * @param map whose place it takes, with its texture coordinates, which are those of the wrinkles; null for none.
 */
export function flatNormalTexture(map: Texture | null): DataTexture {
  const [half, one] = [0.5, 1].map(DataUtils.toHalfFloat)
  const texture = new DataTexture(Uint16Array.of(half, half, one, one), 1, 1, RGBAFormat, HalfFloatType)
  // A composed map inherits this, and must repeat as the layers do.
  texture.wrapS = texture.wrapT = RepeatWrapping
  // And it is drawn by a shader that was built for this one: on WebGPU that of an unfiltered texture loads texels of level 0.
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
