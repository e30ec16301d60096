import {
  ClampToEdgeWrapping,
  DataArrayTexture,
  DataTexture,
  DataUtils,
  FloatType,
  HalfFloatType,
  LinearFilter,
  LinearMipmapLinearFilter,
  NearestFilter,
  RedFormat,
  RGBAFormat,
} from 'three'
import type { Activations } from '../core/activations.ts'
import { MAX_AREAS } from '../core/limits.ts'
import type { ImageArray } from '../core/pack.ts'

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
 * Maps of the skin on the GPU: four channels, filtered with mipmaps, as stored (no colour conversion).
 *
 * @param anisotropy that of the map they are mixed with, so that both blur alike at a slant.
 */
export function colourTexture(colours: ImageArray, anisotropy: number): DataArrayTexture {
  const texture = new DataArrayTexture(colours.data, colours.width, colours.height, colours.depth)
  texture.minFilter = LinearMipmapLinearFilter
  texture.generateMipmaps = true
  texture.anisotropy = anisotropy
  return finish(texture)
}

/** The table of activations on the GPU: one column per area, see `Activations`. */
export function activationTexture(activations: Activations): DataTexture {
  const texture = new DataTexture(activations.table, MAX_AREAS, 2, RGBAFormat, FloatType)
  texture.minFilter = NearestFilter
  texture.magFilter = NearestFilter
  texture.needsUpdate = true
  return texture
}

/**
 * One texel that points straight out of the surface, for a material that has no normal map. In half floats,
 * since no byte is exactly 0.5: skin without wrinkles must look as it did before.
 */
export function flatNormalTexture(): DataTexture {
  const [half, one] = [0.5, 1].map(DataUtils.toHalfFloat)
  const texture = new DataTexture(Uint16Array.of(half, half, one, one), 1, 1, RGBAFormat, HalfFloatType)
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
