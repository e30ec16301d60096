import { type DataArrayTexture, type MeshStandardMaterial, SRGBColorSpace } from 'three'
import { isSlice } from '../../core/check-areas.ts'
import { FurrowError } from '../../core/error.ts'
import { combineNormals } from '../../core/normals/combine-normals.ts'
import { scaleNormals } from '../../core/normals/scale-normals.ts'
import { packColours } from '../../core/pack.ts'
import type { RgbaImage } from '../../core/types.ts'
import { readTexture } from '../loader/read-texture.ts'
import { mapTexture } from './textures.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'
import type { WrinkleTextures } from './wrinkle-textures.ts'

/** Texture array for the shader of the mode `paper`. Its three slices are diffuse colours, smooth normals and wrinkled normals. */
export interface PaperArray {
  texture: DataArrayTexture
  diffuseIsSrgb: boolean
  /** Version of the layer maps from which the array was packed, see `WrinkleTextures`. */
  version: number
}

/**
 * Packs the texture array for the mode `paper`.
 *
 * @param smoothMap original normal map of the material, or null.
 * @throws FurrowError if there are several layers, or maps cannot be read or differ in size.
 */
export function packPaperArray(
  { layers, version }: WrinkleTextures,
  material: WrinkleMaterial,
  smoothMap: WrinkleMaterial['normalMap'],
): PaperArray {
  if (layers.length !== 1) {
    throw new FurrowError({
      code: 'unsupported',
      who: 'Wrinkles.mode',
      problem: 'the paper mode supports one layer only',
      value: layers.map(({ name }) => name).join(', '),
      limit: 'one layer',
      remedy: 'use the default mode',
    })
  }
  const [{ kind, normal, normalScale }] = layers
  if (isSlice(normal)) {
    throw new FurrowError({
      code: 'unsupported',
      who: 'Wrinkles.mode',
      problem: 'the paper mode does not support compressed maps',
      value: layers[0].name,
      remedy: 'use the default mode, or a file with PNG or WebP maps',
    })
  }
  const wrinkles = scaleNormals(normal, normalScale ?? 1)
  const { map } = material as Partial<MeshStandardMaterial>
  const diffuse = map ? readTexture(map, 'Wrinkles.mode') : filled(wrinkles, [255, 255, 255, 255])
  const smooth = smoothMap ? readTexture(smoothMap, 'Wrinkles.mode') : filled(wrinkles, [128, 128, 255, 255])
  const wrinkled = kind === 'detail' ? combineNormals(smooth, wrinkles) : wrinkles
  const colours = packColours([diffuse, smooth, wrinkled], 'Wrinkles.mode paper')
  return {
    texture: mapTexture(colours, material.normalMap?.anisotropy ?? 1),
    diffuseIsSrgb: map?.colorSpace === SRGBColorSpace,
    version,
  }
}

function filled({ width, height }: RgbaImage, texel: number[]): RgbaImage {
  const data = new Uint8Array(width * height * 4)
  for (let i = 0; i < data.length; i++) data[i] = texel[i % 4]
  return { width, height, data }
}
