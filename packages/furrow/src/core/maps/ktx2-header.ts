import { FurrowError } from '../error.ts'
import { MAX_IMAGE_BYTES, MAX_IMAGE_SIDE, MAX_SLICES } from '../limits.ts'
import { imageTypeOf } from './image-type.ts'
import type { TextureShape } from './rules.ts'

// Khronos, KTX File Format Specification 2.0, sections 3 and 5; offsets in bytes.
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

// Khronos Data Format Specification 1.3: offsets in the data format descriptor, colour models, channels with alpha.
const COLOUR_MODEL = 12
const SAMPLES = 28
const SAMPLE_BYTES = 16
const MODELS: Readonly<Record<number, 'etc1s' | 'uastc'>> = { 163: 'etc1s', 166: 'uastc' }
const UASTC_RGBA = 3

/** What the header of a KTX 2 file says of an image in any encoding. */
export interface Ktx2Image {
  /** VkFormat; 0 where the data format descriptor tells instead. */
  format: number
  width: number
  height: number
  /** Slices of an array, 0 where it is a plain image. */
  slices: number
  /** At least 1. */
  levels: number
  /** Bytes of its largest level, all slices, in RGBA. */
  decodedBytes: number
}

/** What the header of a KTX 2 file says that KHR_texture_basisu allows. */
export interface Ktx2Header extends TextureShape {
  slices: number
  layout: string
  encoding: 'etc1s' | 'uastc'
}

/** Throws an error with what is wrong with a file, and the numbers that are. */
export type Ktx2Fault = (problem: string, value?: string) => never

/**
 * Reads the header of a KTX 2 file and checks it before anything is decoded: a 2D image or array of at most 8192 texels on a side, 256
 * slices and 256 MiB in RGBA, whose levels are within the file and no larger than they can be.
 *
 * @param fail throws where it is anything else, or cut off.
 */
export function readKtx2Image(bytes: Uint8Array, fail: Ktx2Fault): Ktx2Image {
  if (imageTypeOf(bytes) !== 'image/ktx2') fail('it is not KTX 2')
  const word = wordReader(bytes, fail)
  const [format, width, height, depth, slices, faces, count, scheme] = Object.values(HEADER).map(word)
  if (width === 0 || height === 0 || depth > 0 || faces !== 1) fail('it is a cube, 3D or 1D texture')
  const decodedBytes = 4 * width * height * Math.max(slices, 1)
  if (Math.max(width, height) > MAX_IMAGE_SIDE || slices > MAX_SLICES || decodedBytes > MAX_IMAGE_BYTES) {
    fail('it is too large', `${width} x ${height} x ${slices}`)
  }
  const levels = Math.max(count, 1)
  // Down to 1 x 1.
  if (levels > 32 - Math.clz32(Math.max(width, height))) fail('it has too many levels', `${levels}`)
  // Without compression, blocks of 4 x 4 texels in 16 bytes each, or RGBA.
  const blocks = 16 * Math.ceil(width / 4) * Math.ceil(height / 4) * Math.max(slices, 1)
  const most = format === 0 ? blocks : decodedBytes
  for (let level = 0; level < levels; level++) {
    const field = (at: number) => {
      const start = LEVEL_INDEX + LEVEL_BYTES * level + at
      return word(start) + 2 ** 32 * word(start + 4)
    }
    const [offset, length, whole] = [0, 8, 16].map(field)
    if (offset + length > bytes.length) fail('it is cut off', `${bytes.length} bytes`)
    // What decoders make room for.
    if (scheme === ZSTANDARD && whole > most) fail('a level is larger than the image', `${whole} bytes`)
  }
  return { format, width, height, slices, levels, decodedBytes }
}

/**
 * Reads the header of a KTX 2 file and checks it by KHR_texture_basisu, as `readKtx2Image` does and further: it is in ETC1S or UASTC.
 *
 * @param who names the texture in errors.
 * @throws FurrowError when it is anything else.
 */
export function readKtx2Header(bytes: Uint8Array, who: string): Ktx2Header {
  const fail: Ktx2Fault = (problem, value) => {
    throw new FurrowError({
      code: 'unreadable',
      who,
      problem,
      value,
      limit: 'KTX 2: a 2D image or array in UASTC or ETC1S',
      remedy: 'pack the file again',
    })
  }
  const { format, width, height, slices, levels } = readKtx2Image(bytes, fail)
  const word = wordReader(bytes, fail)
  const dfd = word(HEADER.dfd)
  const model = word(dfd + COLOUR_MODEL) & 0xff
  const encoding = format === 0 ? MODELS[model] : undefined
  if (!encoding) return fail('its encoding is not for GPUs of all kinds', `format ${format}, model ${model}`)
  const layout = [encoding, hasAlpha(word, dfd, encoding) && 'alpha', `${levels} levels`]
  return { width, height, slices, encoding, layout: layout.filter(Boolean).join(', ') }
}

type ReadWord = (at: number) => number

function wordReader(bytes: Uint8Array, fail: Ktx2Fault): ReadWord {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  return (at) => {
    if (at + 4 > bytes.length) fail('it is cut off', `${bytes.length} bytes`)
    return view.getUint32(at, true)
  }
}

/** ETC1S has alpha in a second sample, UASTC says so in the type of its one. */
function hasAlpha(word: ReadWord, dfd: number, encoding: Ktx2Header['encoding']): boolean {
  const type = (word(dfd + SAMPLES) >>> 24) & 0xf
  if (encoding === 'uastc') return type === UASTC_RGBA
  return word(dfd + 8) >>> 16 >= SAMPLES - 4 + 2 * SAMPLE_BYTES
}
