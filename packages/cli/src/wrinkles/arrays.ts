import { FurrowError, type GrayImage } from 'furrow'
import sharp from 'sharp'
import { MOST_BASIS_TEXELS } from '../array/basis.ts'
import { writeArray } from '../array/ktx2.ts'
import type { FileImage, LayerImages } from './embed.ts'
import type { CheckedImage } from './map-images.ts'

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
    const { width, height } = sameSize(images, kind, who)
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
  const { width, height } = weights[0]!
  const slices = Array.from({ length: Math.ceil(weights.length / AREAS_PER_SLICE) }, (_, slice) => {
    const pixels = new Uint8Array(4 * width * height)
    for (const [k, { data }] of weights
      .slice(slice * AREAS_PER_SLICE)
      .slice(0, AREAS_PER_SLICE)
      .entries()) {
      for (let i = 0; i < data.length; i++) pixels[4 * i + k] = data[i]!
    }
    return pixels
  })
  const names = slices.map((_, i) => `areas-${i}`)
  const bytes = await encode({ width, height, channels: 4, srgb: false, names, layers: slices }, false, who)
  return slices.map((_, slice) => ({ name: 'areas', mimeType: MIME_TYPE, bytes, slice }))
}

async function encode(array: Parameters<typeof writeArray>[0], mipmaps: boolean, who: string) {
  const { width, height, layers } = array
  if (width * height * layers.length > MOST_BASIS_TEXELS) {
    throw new FurrowError({
      who,
      what: 'too many texels for one compressed array',
      value: `${layers.length} x ${width} x ${height}`,
      limit: `${MOST_BASIS_TEXELS} in all`,
      remedy: 'scale the images (--size, --area-size), or leave --ktx2 away',
    })
  }
  if (width % 4 !== 0 || height % 4 !== 0) {
    throw new FurrowError({
      who,
      what: 'a size that compressed arrays cannot have',
      value: `${width} x ${height}`,
      limit: 'multiples of 4 texels',
      remedy: 'scale the images (--size, --area-size), or leave --ktx2 away',
    })
  }
  return writeArray(array, 'uastc', mipmaps)
}

function sameSize(images: readonly CheckedImage[], kind: string, who: string) {
  const sizes = images.map(({ width, height }) => `${width} x ${height}`)
  if (new Set(sizes).size === 1) return images[0]!
  throw new FurrowError({
    who,
    what: `the ${kind} maps of the layers differ in size`,
    value: sizes.join(', '),
    limit: 'one size for all slices of an array',
    remedy: 'scale them to one size (--size)',
  })
}

async function rgba(bytes: Uint8Array): Promise<Uint8Array> {
  const image = sharp(bytes, { failOn: 'truncated', ignoreIcc: true }).toColourspace('srgb').ensureAlpha()
  return new Uint8Array(await image.raw().toBuffer())
}
