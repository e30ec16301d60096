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
} from 'three'
import type { ImageArray } from '../../core/pack.ts'

/**
 * Areas on the GPU: one channel, filtered, without mipmaps (they are soft already, and mipmaps would bleed
 * across UV islands). Edges are clamped, as in the reference.
 */
export function areaTexture(areas: ImageArray): DataArrayTexture {
  const texture = new DataArrayTexture(areas.data, areas.width, areas.height, areas.depth)
  texture.format = RedFormat
  texture.minFilter = LinearFilter
  return finish(texture)
}

/**
 * Maps of the skin on the GPU, one channel or four, filtered with mipmaps.
 *
 * @param anisotropy that of the map they are mixed with, so that both blur alike at a slant.
 * @param colorSpace `SRGBColorSpace` for colours that shall be linear when sampled; as stored unless told.
 */
export function mapTexture(
  maps: ImageArray,
  anisotropy: number,
  colorSpace: ColorSpace = NoColorSpace,
): DataArrayTexture {
  const texture = new DataArrayTexture(maps.data, maps.width, maps.height, maps.depth)
  if (maps.channels === 1) texture.format = RedFormat
  texture.colorSpace = colorSpace
  texture.minFilter = LinearMipmapLinearFilter
  texture.generateMipmaps = true
  texture.anisotropy = anisotropy
  return finish(texture)
}

/**
 * One texel that points straight out of the surface, for a material that has no normal map. In half floats,
 * since no byte is exactly 0.5: skin without wrinkles must look as it did before.
 */
export function flatNormalTexture(): DataTexture {
  const [half, one] = [0.5, 1].map(DataUtils.toHalfFloat)
  const texture = new DataTexture(Uint16Array.of(half, half, one, one), 1, 1, RGBAFormat, HalfFloatType)
  // A map that is composed from it repeats as the layers do.
  texture.wrapS = texture.wrapT = RepeatWrapping
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
