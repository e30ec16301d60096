import { FurrowError } from './error.ts'
import { MAX_IMAGE_BYTES, MAX_IMAGE_SIDE } from './limits.ts'
import type { TextureShape } from './map-rules.ts'

// Khronos, KTX File Format Specification 2.0, sections 3 and 5; offsets in bytes.
const IDENTIFIER = [0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30, 0xbb, 0x0d, 0x0a, 0x1a, 0x0a]
const HEADER = { vkFormat: 12, width: 20, height: 24, depth: 28, layers: 32, faces: 36, levels: 40, dfd: 48 }
const LEVEL_INDEX = 80
const LEVEL_BYTES = 24

// Khronos Data Format Specification 1.3: offsets in the data format descriptor, colour models, channels with alpha.
const COLOUR_MODEL = 12
const SAMPLES = 28
const SAMPLE_BYTES = 16
const MODELS: Readonly<Record<number, 'etc1s' | 'uastc'>> = { 163: 'etc1s', 166: 'uastc' }
const UASTC_RGBA = 3

/** What the header of a KTX 2 file says. */
export interface Ktx2Header extends TextureShape {
  slices: number
  layout: string
  encoding: 'etc1s' | 'uastc'
}

/**
 * Reads the header of a KTX 2 file and checks it by KHR_texture_basisu, before anything is decoded: a 2D image or array in ETC1S or
 * UASTC whose levels are within the file.
 *
 * @param who names the texture in errors.
 * @throws FurrowError when it is anything else, or cut off.
 */
export function readKtx2Header(bytes: Uint8Array, who: string): Ktx2Header {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  const fail = (what: string, value?: unknown): never => {
    throw new FurrowError({
      code: 'unreadable',
      who,
      what,
      value,
      limit: 'KTX 2: a 2D image or array in UASTC or ETC1S',
      remedy: 'pack the file again',
    })
  }
  if (bytes.length < LEVEL_INDEX || IDENTIFIER.some((byte, i) => bytes[i] !== byte))
    fail('it is no KTX 2 file')
  const word = (at: number) => (at + 4 <= bytes.length ? view.getUint32(at, true) : fail('it is cut off'))
  const [format, width, height, depth, slices, faces, count, dfd] = Object.values(HEADER).map(word)
  if (width === 0 || height === 0 || depth > 0 || faces !== 1) fail('it is a cube, 3D or 1D texture')
  const texels = width * height * Math.max(slices, 1)
  if (Math.max(width, height) > MAX_IMAGE_SIDE || 4 * texels > MAX_IMAGE_BYTES) {
    fail('it is too large', `${width} x ${height} x ${slices}`)
  }
  const model = word(dfd + COLOUR_MODEL) & 0xff
  const encoding = format === 0 ? MODELS[model] : undefined
  if (!encoding) return fail('its encoding is not for GPUs of all kinds', `format ${format}, model ${model}`)
  const levels = Math.max(count, 1)
  for (let level = 0; level < levels; level++) {
    const at = LEVEL_INDEX + LEVEL_BYTES * level
    const [offset, length] = [0, 8].map((field) => word(at + field) + 2 ** 32 * word(at + field + 4))
    if (offset + length > bytes.length) fail('it is cut off', `${bytes.length} bytes`)
  }
  const layout = [encoding, hasAlpha(word, dfd, encoding) && 'alpha', `${levels} levels`]
  return { width, height, slices, encoding, layout: layout.filter(Boolean).join(', ') }
}

/** ETC1S has alpha in a second sample, UASTC says so in the type of its one. */
function hasAlpha(word: (at: number) => number, dfd: number, encoding: Ktx2Header['encoding']): boolean {
  const type = (word(dfd + SAMPLES) >>> 24) & 0xf
  if (encoding === 'uastc') return type === UASTC_RGBA
  return word(dfd + 8) >>> 16 >= SAMPLES - 4 + 2 * SAMPLE_BYTES
}
