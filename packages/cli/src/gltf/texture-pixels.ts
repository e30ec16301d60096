import { FurrowError, type TextureReference } from 'furrow'
import { readArray } from '../array/ktx2.ts'
import { cannotRead } from '../errors.ts'
import { decodePixels, type Pixels } from '../images/pixels.ts'
import type { Glb } from './glb-file.ts'
import { imageOf, isKtx2 } from './texture-image.ts'

type DecodedArray = Awaited<ReturnType<typeof readArray>>

/** Decoded textures of files, by index: several areas share an image, and several maps an array. */
type Cache<T> = WeakMap<Glb, Map<number, Promise<T>>>

const images: Cache<Pixels> = new WeakMap()
const arrays: Cache<DecodedArray> = new WeakMap()

/**
 * Decodes what a texture info refers to: an image, or one slice of a KTX 2 array.
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
    return cached(images, glb, index, () => decodePixels(image.bytes, `"${image.name}"`, who))
  }
  const { width, height, channels, layers } = await arrayOf(glb, index, who)
  const data = layers.at(slice)
  if (data) return { width, height, channels, data }
  throw new FurrowError({
    code: 'out-of-range',
    who,
    what: `texture ${index} has no such slice`,
    value: slice,
    limit: `0 to ${layers.length - 1}`,
    remedy: 'pack the file again',
  })
}

/** Decodes all layers of a KTX 2 texture. Throws FurrowError when it cannot be decoded. */
export function arrayOf(glb: Glb, index: number, who: string): Promise<DecodedArray> {
  return cached(arrays, glb, index, () => decodeArray(glb, index, who))
}

function cached<T>(cache: Cache<T>, glb: Glb, index: number, decode: () => Promise<T>): Promise<T> {
  const known = cache.get(glb) ?? new Map<number, Promise<T>>()
  cache.set(glb, known)
  const texture = known.get(index) ?? decode()
  known.set(index, texture)
  return texture
}

async function decodeArray(glb: Glb, index: number, who: string): Promise<DecodedArray> {
  const { bytes, name } = imageOf(glb, index, who)
  try {
    return await readArray(bytes)
  } catch (error) {
    const hints = { limit: 'KTX 2: R8, RGBA8, UASTC or ETC1S', remedy: 'pack the file again' }
    throw cannotRead(who, `the image "${name}"`, error, hints)
  }
}
