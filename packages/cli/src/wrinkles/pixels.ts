import { FurrowError, type TextureReference } from 'furrow'
import sharp from 'sharp'
import { readArray } from '../array/ktx2.ts'
import { firstLine } from '../images.ts'
import type { Glb } from './glb-file.ts'
import { type Pixels, readPixels } from './map-images.ts'
import { imageOf, isKtx2 } from './wrinkled-file.ts'

type DecodedArray = Awaited<ReturnType<typeof readArray>>

const arrays = new WeakMap<Glb, Map<number, Promise<DecodedArray>>>()

/**
 * What a texture info means, decoded: an image, or one slice of a KTX 2 array.
 *
 * @throws FurrowError when it cannot be decoded, or there is no such slice.
 */
export async function pixelsOf(
  glb: Glb,
  { index, slice = 0 }: TextureReference,
  who: string,
): Promise<Pixels> {
  const image = imageOf(glb, index, who)
  if (!isKtx2(image)) return readPixels(image.bytes, `the image "${image.name}"`, who)
  const { width, height, channels, layers } = await arrayOf(glb, index, who)
  const data = layers[slice]
  if (data) return { width, height, channels, data }
  throw new FurrowError({
    who,
    what: `texture ${index} has no such slice`,
    value: slice,
    limit: `0 to ${layers.length - 1}`,
    remedy: 'pack the file again',
  })
}

/** A KTX 2 image decoded, once for all that ask. */
export function arrayOf(glb: Glb, index: number, who: string): Promise<DecodedArray> {
  const known = arrays.get(glb) ?? new Map<number, Promise<DecodedArray>>()
  arrays.set(glb, known)
  const found = known.get(index) ?? decode(glb, index, who)
  known.set(index, found)
  return found
}

/** As a PNG file; without alpha where that is 1 throughout. */
export async function encodePixels({ width, height, channels, data }: Pixels): Promise<Uint8Array> {
  const image = sharp(data, { raw: { width, height, channels } })
  const opaque = channels === 4 && data.every((value, i) => i % 4 !== 3 || value === 255)
  return (opaque ? image.removeAlpha() : image).png({ compressionLevel: 9 }).toBuffer()
}

async function decode(glb: Glb, index: number, who: string): Promise<DecodedArray> {
  const { bytes, name } = imageOf(glb, index, who)
  try {
    return await readArray(bytes)
  } catch (error) {
    throw new FurrowError({
      who,
      what: `cannot decode the image "${name}" (${firstLine(error)})`,
      limit: 'KTX 2: R8, RGBA8, UASTC or ETC1S',
      remedy: 'pack the file again',
    })
  }
}
