import { type DataArrayTexture, type MeshStandardMaterial, SRGBColorSpace } from 'three'
import { combineNormals } from '../../core/combine-normals.ts'
import { FurrowError } from '../../core/error.ts'
import { packColours } from '../../core/pack.ts'
import { scaleNormals } from '../../core/scale-normals.ts'
import type { ArraySlice, Layer, RgbaImage } from '../../core/types.ts'
import { isSlice } from '../../core/wrinkle-set.ts'
import { readTexture } from '../loader/read-texture.ts'
import { mapTexture } from './textures.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** The paper's array: diffuse, smooth normals, wrinkled normals. */
export interface PaperArray {
  texture: DataArrayTexture
  /** Whether the diffuse texture is encoded in sRGB, as the material's own map says. */
  diffuseIsSrgb: boolean
}

/**
 * Packs what the paper's shader reads.
 *
 * @param smoothMap the material's own normal map; null where it has none.
 * @throws FurrowError with more than one layer, or maps that cannot be read or differ in size.
 */
export function packPaperArray(
  layers: readonly Layer<ArraySlice>[],
  material: WrinkleMaterial,
  smoothMap: WrinkleMaterial['normalMap'],
): PaperArray {
  if (layers.length !== 1) {
    throw new FurrowError({
      code: 'unsupported',
      who: 'Wrinkles.mode',
      what: 'the paper knows one wrinkled normal map',
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
      what: "the paper's array cannot be packed from compressed maps",
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
  }
}

function filled({ width, height }: RgbaImage, texel: number[]): RgbaImage {
  const data = new Uint8Array(width * height * 4)
  for (let i = 0; i < data.length; i++) data[i] = texel[i % 4]
  return { width, height, data }
}
