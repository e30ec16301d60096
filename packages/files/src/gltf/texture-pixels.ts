import { FurrowError } from 'furrow'
import { DecodedBytes, type TextureReference } from 'furrow/internal'
import { decodeImage, measureImage } from '#images'
import { withImageErrors } from '../images/image-errors.ts'
import type { Pixels } from '../images/pixels.ts'
import { type DecodedArray, decodeArray as decodeKtx2 } from '../ktx2/ktx2.ts'
import { readHeader } from '../ktx2/ktx2-header.ts'
import type { Glb } from './glb.ts'
import { imageOf, isKtx2 } from './texture-image.ts'

/**
 * Cache of decoded textures by texture index. Several areas can share an image, and several maps can share a KTX 2
 * array.
 */
type Cache<T> = WeakMap<Glb, Map<number, Promise<T>>>

const images: Cache<Pixels> = new WeakMap()
const arrays: Cache<DecodedArray> = new WeakMap()

/**
 * Decodes the image of a texture, or one slice of a KTX 2 array.
 *
 * @throws FurrowError if the image cannot be decoded, or the slice is missing.
 */
export async function pixelsOf(
  glb: Glb,
  { index, slice = 0 }: TextureReference,
  who: string,
): Promise<Pixels> {
  const image = imageOf(glb, index, who)
  if (!isKtx2(image)) {
    return cached(images, glb, index, who, () => decodeImage(image.bytes, `"${image.name}"`, who))
  }
  const { width, height, channels, layers } = await arrayOf(glb, index, who)
  const data = layers.at(slice)
  if (data) return { width, height, channels, data }
  throw new FurrowError({
    code: 'out-of-range',
    who,
    problem: `missing slice in texture ${index}`,
    value: slice,
    limit: `0 to ${layers.length - 1}`,
    remedy: 'pack the file again',
  })
}

/** Decodes all slices of a KTX 2 texture. Throws if it cannot be decoded. */
export function arrayOf(glb: Glb, index: number, who: string): Promise<DecodedArray> {
  return cached(arrays, glb, index, who, () => decodeArray(glb, index, who))
}

/** Reads the size of a texture from its header. Throws if the header cannot be read. */
export async function sizeOf(
  glb: Glb,
  index: number,
  who: string,
): Promise<{ width: number; height: number; slices?: number }> {
  const image = imageOf(glb, index, who)
  const { bytes, name } = image
  if (!isKtx2(image)) return measureImage(bytes, `"${name}"`, who)
  return withArrayErrors(name, who, async () => readHeader(bytes))
}

async function cached<T>(
  cache: Cache<T>,
  glb: Glb,
  index: number,
  who: string,
  decode: () => Promise<T>,
): Promise<T> {
  const known = cache.get(glb) ?? new Map<number, Promise<T>>()
  cache.set(glb, known)
  const texture = known.get(index) ?? reserve(glb, index, who).then(decode)
  known.set(index, texture)
  return texture
}

/** Total decoded size of the cached textures per file. */
const decoded = new WeakMap<Glb, DecodedBytes>()

async function reserve(glb: Glb, index: number, who: string): Promise<void> {
  const size = await sizeOf(glb, index, who)
  const count = decoded.get(glb) ?? new DecodedBytes()
  decoded.set(glb, count)
  count.add(index, size, who)
}

async function decodeArray(glb: Glb, index: number, who: string): Promise<DecodedArray> {
  const { bytes, name } = imageOf(glb, index, who)
  return withArrayErrors(name, who, () => decodeKtx2(bytes))
}

function withArrayErrors<T>(name: string, who: string, read: () => Promise<T>): Promise<T> {
  const hints = { limit: 'KTX 2: R8, RGBA8, UASTC or ETC1S', remedy: 'pack the file again' }
  return withImageErrors(`"${name}"`, who, read, hints)
}
