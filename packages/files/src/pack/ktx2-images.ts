import type { GrayImage } from 'furrow'
import { decodeImage } from '#images'
import { toRgba } from '../images/pixels.ts'
import { checkBasisSize } from '../ktx2/basis.ts'
import type { NamedArray } from '../ktx2/image-array.ts'
import { writeArray } from '../ktx2/ktx2.ts'
import { interleave } from './area-images.ts'
import { type CheckedImage, checkOneSize } from './checked-image.ts'
import type { FileImage, LayerImages } from './embed.ts'

/** Number of areas in one slice of a texture array, one per channel. */
export const AREAS_PER_SLICE = 4

const MIME_TYPE = 'image/ktx2'

/**
 * Maps by kind. Each kind becomes one texture array. Occlusion, blood and onset share an image. Heights stay PNG, because
 * code on the CPU reads them to displace the surface.
 */
const KINDS = [['normal'], ['baseColor'], ['roughness'], ['occlusion', 'blood', 'onset']] as const

/**
 * Encodes the maps of all layers as KTX 2 arrays in UASTC with mipmaps, one array per kind. Heights stay PNG.
 *
 * @throws FurrowError if maps of one kind differ in size or have too many texels together, or if their sides are not
 *   multiples of 4 texels.
 */
export async function encodeMapArrays(
  layers: readonly (LayerImages & { normal: CheckedImage })[],
  who: string,
): Promise<LayerImages[]> {
  const encoded: LayerImages[] = layers.map((layer) => ({ ...layer }))
  for (const maps of KINDS) {
    const [kind] = maps
    const mapOf = (layer: LayerImages) => maps.map((map) => layer[map]).find((map) => map !== undefined)
    const withMap = encoded.filter(mapOf)
    if (withMap.length === 0) continue
    const images = withMap.map((layer) => mapOf(layer) as CheckedImage)
    checkOneSize(images, kind, who)
    const { width, height } = images[0]
    const pixels = await Promise.all(
      images.map(async ({ bytes, name }) => toRgba(await decodeImage(bytes, name, who))),
    )
    const names = withMap.map((_, i) => `layer-${i}`)
    const srgb = kind === 'baseColor'
    const bytes = await encode({ width, height, channels: 4, srgb, names, layers: pixels }, true, who)
    for (const [slice, layer] of withMap.entries()) {
      const image = { name: `${kind} maps`, mimeType: MIME_TYPE, bytes, slice }
      for (const map of maps) if (layer[map]) layer[map] = image
    }
  }
  return encoded
}

/**
 * Encodes areas of equal size as one KTX 2 array in UASTC, four areas per slice. The array has no mipmaps, because they
 * would bleed across UV islands.
 */
export async function encodeAreaArray(weights: readonly GrayImage[], who: string): Promise<FileImage[]> {
  const { width, height } = weights[0]
  const slices = Array.from({ length: Math.ceil(weights.length / AREAS_PER_SLICE) }, (_, slice) => {
    const first = slice * AREAS_PER_SLICE
    return interleave(weights.slice(first, first + AREAS_PER_SLICE), 4).data
  })
  const names = slices.map((_, i) => `areas-${i}`)
  const bytes = await encode({ width, height, channels: 4, srgb: false, names, layers: slices }, false, who)
  return slices.map((_, slice) => ({ name: 'areas', mimeType: MIME_TYPE, bytes, slice }))
}

function encode(array: NamedArray, mipmaps: boolean, who: string): Promise<Uint8Array> {
  checkBasisSize(array, who, 'scale the images (--size, --area-size), or omit --ktx2')
  return writeArray(array, 'uastc', mipmaps)
}
