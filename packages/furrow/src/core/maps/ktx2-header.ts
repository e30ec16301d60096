import { FurrowError } from '../error.ts'
import { MAX_IMAGE_BYTES, MAX_IMAGE_SIDE, MAX_SLICES } from '../limits.ts'
import { imageTypeOf } from './image-type.ts'
import type { TextureShape } from './rules.ts'

// Byte offsets from the Khronos KTX File Format Specification 2.0, sections 3 and 5.
const HEADER = {
  format: 12,
  width: 20,
  height: 24,
  depth: 28,
  slices: 32,
  faces: 36,
  levels: 40,
  scheme: 44,
  dfd: 48,
}
const LEVEL_INDEX = 80
const LEVEL_BYTES = 24
const ZSTANDARD = 2

// Data format descriptor: byte offsets, colour models and channel types, from the Khronos Data Format Specification 1.3.
const COLOUR_MODEL = 12
const SAMPLES = 28
const SAMPLE_BYTES = 16
const MODELS: Readonly<Record<number, 'etc1s' | 'uastc'>> = { 163: 'etc1s', 166: 'uastc' }
const UASTC_RGBA = 3

/** Header of a KTX 2 file with any encoding. */
export interface Ktx2Image {
  /** VkFormat; 0 if the data format descriptor names the format instead (ETC1S and UASTC). */
  format: number
  width: number
  height: number
  /** Number of slices of a texture array; 0 for a single image. */
  slices: number
  /** Number of mipmap levels, at least 1. */
  levels: number
  /** Decoded size of the largest mipmap level in bytes: RGBA, all slices. */
  decodedBytes: number
}

/** Header of a KTX 2 file with an encoding that KHR_texture_basisu allows. */
export interface Ktx2Header extends TextureShape {
  slices: number
  layout: string
  encoding: 'etc1s' | 'uastc'
}

/** Throws the caller's error for a problem with a KTX 2 file. */
export type FailKtx2 = (problem: string, value?: string) => never

/**
 * Reads and checks the header of a KTX 2 file without decoding the image. The file must contain a 2D image or 2D array with valid mipmap
 * levels. Limits are 8192 texels in width and height, 256 slices, and 256 MiB in RGBA.
 *
 * @param fail is called for an invalid or truncated file, and must throw.
 */
export function readKtx2Image(bytes: Uint8Array, fail: FailKtx2): Ktx2Image {
  if (imageTypeOf(bytes) !== 'image/ktx2') fail('not a KTX 2 file')
  const word = wordReader(bytes, fail)
  const [format, width, height, depth, slices, faces, count, scheme] = Object.values(HEADER).map(word)
  if (width === 0 || height === 0 || depth > 0 || faces !== 1) fail('cube, 3D or 1D texture')
  const decodedBytes = 4 * width * height * Math.max(slices, 1)
  if (Math.max(width, height) > MAX_IMAGE_SIDE || slices > MAX_SLICES || decodedBytes > MAX_IMAGE_BYTES) {
    fail('texture too large', `${width} x ${height} x ${slices}`)
  }
  const levels = Math.max(count, 1)
  if (levels > 32 - Math.clz32(Math.max(width, height))) fail('too many mipmap levels', `${levels}`)
  // Maximum size of a mipmap level without Zstandard compression. UASTC and ETC1S need at most 16 bytes per block of 4 x 4 texels.
  // Other formats need at most as many bytes as RGBA.
  const blocks = 16 * Math.ceil(width / 4) * Math.ceil(height / 4) * Math.max(slices, 1)
  const maxBytes = format === 0 ? blocks : decodedBytes
  for (let level = 0; level < levels; level++) {
    const field = (at: number) => {
      const start = LEVEL_INDEX + LEVEL_BYTES * level + at
      return word(start) + 2 ** 32 * word(start + 4)
    }
    const [offset, length, unpacked] = [0, 8, 16].map(field)
    if (offset + length > bytes.length) fail('truncated file', `${bytes.length} bytes`)
    // Decoders allocate the size that the file declares, so a wrong size could exhaust memory.
    if (scheme === ZSTANDARD && unpacked > maxBytes)
      fail('mipmap level larger than the image', `${unpacked} bytes`)
  }
  return { format, width, height, slices, levels, decodedBytes }
}

/**
 * Reads the header of a KTX 2 file with `readKtx2Image`, and checks that the encoding is ETC1S or UASTC, as KHR_texture_basisu requires.
 *
 * @param who name of the texture in errors.
 * @throws FurrowError if a check fails.
 */
export function readKtx2Header(bytes: Uint8Array, who: string): Ktx2Header {
  const fail: FailKtx2 = (problem, value) => {
    throw new FurrowError({
      code: 'unreadable',
      who,
      problem,
      value,
      limit: 'a 2D image or array in KTX 2, encoded as UASTC or ETC1S',
      remedy: 'pack the file again',
    })
  }
  const { format, width, height, slices, levels } = readKtx2Image(bytes, fail)
  const word = wordReader(bytes, fail)
  const dfd = word(HEADER.dfd)
  const model = word(dfd + COLOUR_MODEL) & 0xff
  const encoding = format === 0 ? MODELS[model] : undefined
  if (!encoding) return fail('unsupported encoding', `format ${format}, model ${model}`)
  const layout = [encoding, hasAlpha(word, dfd, encoding) && 'alpha', `${levels} levels`]
  return { width, height, slices, encoding, layout: layout.filter(Boolean).join(', ') }
}

type ReadWord = (at: number) => number

function wordReader(bytes: Uint8Array, fail: FailKtx2): ReadWord {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  return (at) => {
    if (at + 4 > bytes.length) fail('truncated file', `${bytes.length} bytes`)
    return view.getUint32(at, true)
  }
}

/** Whether an image has alpha. In the descriptor, ETC1S has a second sample for alpha. UASTC has one sample, with a type such as RGBA. */
function hasAlpha(word: ReadWord, dfd: number, encoding: Ktx2Header['encoding']): boolean {
  const type = (word(dfd + SAMPLES) >>> 24) & 0xf
  if (encoding === 'uastc') return type === UASTC_RGBA
  return word(dfd + 8) >>> 16 >= SAMPLES - 4 + 2 * SAMPLE_BYTES
}
