import { FurrowError, type TextureReference } from 'furrow'
import { readArray } from '../array/ktx2.ts'
import { firstLine } from '../images.ts'
import type { Glb } from './glb-file.ts'
import { type Pixels, readPixels } from './map-images.ts'
import { imageOf, isKtx2 } from './wrinkled-file.ts'

type DecodedArray = Awaited<ReturnType<typeof readArray>>

/** What was decoded, by the index of its texture. */
type Decoded<T> = WeakMap<Glb, Map<number, Promise<T>>>

const images: Decoded<Pixels> = new WeakMap()
const arrays: Decoded<DecodedArray> = new WeakMap()

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
  if (!isKtx2(image)) {
    return once(images, glb, index, () => readPixels(image.bytes, `the image "${image.name}"`, who))
  }
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

/** All layers of a KTX 2 image. */
export function arrayOf(glb: Glb, index: number, who: string): Promise<DecodedArray> {
  return once(arrays, glb, index, () => decode(glb, index, who))
}

/** Several areas share an image, and several maps an array. */
function once<T>(decoded: Decoded<T>, glb: Glb, index: number, make: () => Promise<T>): Promise<T> {
  const known = decoded.get(glb) ?? new Map<number, Promise<T>>()
  decoded.set(glb, known)
  const found = known.get(index) ?? make()
  known.set(index, found)
  return found
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
