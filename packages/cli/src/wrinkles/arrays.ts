import type { GrayImage } from 'furrow'
import sharp from 'sharp'
import { checkBasisSize } from '../array/basis.ts'
import type { NamedArray } from '../array/image-array.ts'
import { writeArray } from '../array/ktx2.ts'
import type { FileImage, LayerImages } from './embed.ts'
import { type CheckedImage, checkOneSize, interleave } from './map-images.ts'

/** Areas that share a slice of an array: one per channel. */
export const AREAS_PER_SLICE = 4

const MIME_TYPE = 'image/ktx2'

/** Kinds of maps, and whether they are colours. */
const KINDS = { normal: false, baseColor: true, roughness: false, occlusion: false, height: false } as const

/**
 * Puts the maps of each kind into one KTX 2 array in UASTC, with mipmaps.
 *
 * @throws FurrowError where maps of one kind differ in size, or have sizes that blocks of 4 x 4 texels cannot have.
 */
export async function mapArrays(
  layers: readonly (LayerImages & { normal: CheckedImage })[],
  who: string,
): Promise<LayerImages[]> {
  const made: LayerImages[] = layers.map((layer) => ({ ...layer }))
  for (const [kind, srgb] of Object.entries(KINDS) as [keyof typeof KINDS, boolean][]) {
    const having = made.filter((layer) => layer[kind])
    if (having.length === 0) continue
    const images = having.map((layer) => layer[kind] as CheckedImage)
    checkOneSize(images, kind, who)
    const { width, height } = images[0]
    const pixels = await Promise.all(images.map(({ bytes }) => rgba(bytes)))
    const names = having.map((_, i) => `layer-${i}`)
    const bytes = await encode({ width, height, channels: 4, srgb, names, layers: pixels }, true, who)
    for (const [slice, layer] of having.entries())
      layer[kind] = { name: `${kind} maps`, mimeType: MIME_TYPE, bytes, slice }
  }
  return made
}

/** Puts areas of one size into one KTX 2 array in UASTC, four to a slice, without mipmaps: those bleed across UV islands. */
export async function areaArray(weights: readonly GrayImage[], who: string): Promise<FileImage[]> {
  const { width, height } = weights[0]
  const slices = Array.from({ length: Math.ceil(weights.length / AREAS_PER_SLICE) }, (_, slice) => {
    const first = slice * AREAS_PER_SLICE
    return interleave(weights.slice(first, first + AREAS_PER_SLICE), 4)
  })
  const names = slices.map((_, i) => `areas-${i}`)
  const bytes = await encode({ width, height, channels: 4, srgb: false, names, layers: slices }, false, who)
  return slices.map((_, slice) => ({ name: 'areas', mimeType: MIME_TYPE, bytes, slice }))
}

function encode(array: NamedArray, mipmaps: boolean, who: string): Promise<Uint8Array> {
  checkBasisSize(array, who, 'scale the images (--size, --area-size), or leave --ktx2 away')
  return writeArray(array, 'uastc', mipmaps)
}

async function rgba(bytes: Uint8Array): Promise<Uint8Array> {
  const image = sharp(bytes, { failOn: 'truncated', ignoreIcc: true }).toColourspace('srgb').ensureAlpha()
  return new Uint8Array(await image.raw().toBuffer())
}
