import { Constants } from '@babylonjs/core/Engines/constants.js'
import { RawTexture } from '@babylonjs/core/Materials/Textures/rawTexture.js'
import { RawTexture2DArray } from '@babylonjs/core/Materials/Textures/rawTexture2DArray.js'
import type { Texture } from '@babylonjs/core/Materials/Textures/texture.js'
import { ToHalfFloat } from '@babylonjs/core/Misc/textureTools.js'
import type { Scene } from '@babylonjs/core/scene.js'
import type { ImageArray } from '../core/image-array.ts'

const FORMATS = {
  1: Constants.TEXTUREFORMAT_RED,
  2: Constants.TEXTUREFORMAT_RG,
  4: Constants.TEXTUREFORMAT_RGBA,
} as const

/** Creates a texture array of areas. It has no filtering, because the shader fetches single texels. */
export function areaTexture(images: ImageArray, scene: Scene): Texture {
  return arrayTexture(images.data, images, scene, Constants.TEXTURE_NEAREST_SAMPLINGMODE)
}

/** Creates a texture array of layer maps with mipmaps. */
export function mapTexture(images: ImageArray, anisotropy: number, scene: Scene): Texture {
  return filtered(
    arrayTexture(images.data, images, scene, Constants.TEXTURE_TRILINEAR_SAMPLINGMODE),
    anisotropy,
  )
}

/** Creates a texture array of sRGB colours with mipmaps. Texels are converted to linear half floats, because Babylon.js has no sRGB arrays. */
export function colourTexture(images: ImageArray, anisotropy: number, scene: Scene): Texture {
  const linear = Uint16Array.from({ length: 256 }, (_, byte) => ToHalfFloat(linearOf(byte / 255)))
  const data = Uint16Array.from(images.data, (byte) => linear[byte])
  return filtered(arrayTexture(data, images, scene, Constants.TEXTURE_TRILINEAR_SAMPLINGMODE), anisotropy)
}

/**
 * Creates a normal map of one flat texel. It stores half floats, because no byte encodes exactly 0.5. With bytes, skin without wrinkles
 * would change slightly.
 */
export function flatNormalTexture(scene: Scene): RawTexture {
  const [half, one] = [0.5, 1].map(ToHalfFloat)
  const texture = new RawTexture(
    Uint16Array.of(half, half, one, one),
    1,
    1,
    Constants.TEXTUREFORMAT_RGBA,
    scene,
    false,
    false,
    Constants.TEXTURE_BILINEAR_SAMPLINGMODE,
    Constants.TEXTURETYPE_HALF_FLOAT,
  )
  texture.name = 'furrow: flat normals'
  return texture
}

/** Converts an sRGB component, 0..1, to linear, 0..1 (IEC 61966-2-1). */
function linearOf(value: number): number {
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4
}

function filtered(texture: Texture, anisotropy: number): Texture {
  texture.anisotropicFilteringLevel = anisotropy
  return texture
}

function arrayTexture(
  data: Uint8Array | Uint16Array,
  { width, height, depth, channels }: ImageArray,
  scene: Scene,
  sampling: number,
): Texture {
  const texture = new RawTexture2DArray(
    data,
    width,
    height,
    depth,
    FORMATS[channels],
    scene,
    sampling === Constants.TEXTURE_TRILINEAR_SAMPLINGMODE,
    false,
    sampling,
    data instanceof Uint16Array ? Constants.TEXTURETYPE_HALF_FLOAT : Constants.TEXTURETYPE_UNSIGNED_BYTE,
  )
  // Coordinates must be clamped to the edge, as in the reference implementation.
  texture.wrapU = texture.wrapV = texture.wrapR = Constants.TEXTURE_CLAMP_ADDRESSMODE
  return texture
}
