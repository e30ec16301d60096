import { MAX_IMAGE_BYTES, MAX_IMAGE_SIDE } from 'furrow'
import { KHR_SUPERCOMPRESSION_ZSTD, VK_FORMAT_UNDEFINED } from 'ktx-parse'
import { kindOf } from '../file-kind.ts'

/** What the header of a KTX 2 file says, as far as it is used here. */
interface ArrayHeader {
  vkFormat: number
  width: number
  height: number
  /** Layers of an array; 1 for a plain image. */
  count: number
  /** Bytes of the largest level of all layers in RGBA. */
  decodedBytes: number
}

const IDENTIFIER = '\xabKTX 20\xbb\r\n\x1a\n'
/** Length of the header, the index, and the first entry of the list of levels (KTX 2.0, 3.1). */
const LENGTH = 104
/** Most layers of an array: what every WebGPU device guarantees. */
const MAX_LAYERS = 256

/**
 * Reads the header of a KTX 2 file and checks it before anything is decoded.
 *
 * @throws Error with a short reason when it is not a 2D image or array, or would take too much memory.
 */
export function readHeader(bytes: Uint8Array): ArrayHeader {
  const kind = kindOf(bytes)
  if (!Buffer.from(bytes.subarray(0, 12)).equals(Buffer.from(IDENTIFIER, 'latin1')))
    throw new Error(kind === undefined ? 'it is not KTX 2' : `it is ${kind}, not KTX 2`)
  if (bytes.length < LENGTH) throw new Error('it is cut off')
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length)
  const word = (at: number) => view.getUint32(at, true)
  const [vkFormat, width, height, depth] = [word(12), word(20), word(24), word(28)]
  const [layers, faces, scheme] = [word(32), word(36), word(44)]
  const count = Math.max(layers, 1)
  if (faces !== 1 || depth > 0 || width === 0 || height === 0)
    throw new Error('it is a cube, 3D or 1D texture')
  if (width > MAX_IMAGE_SIDE || height > MAX_IMAGE_SIDE) {
    throw new Error(`it has ${width} x ${height} of at most ${MAX_IMAGE_SIDE} texels a side`)
  }
  if (count > MAX_LAYERS) throw new Error(`it has ${count} of at most ${MAX_LAYERS} layers`)
  const decodedBytes = 4 * width * height * count
  if (decodedBytes > MAX_IMAGE_BYTES) {
    throw new Error(`it would decode to ${mebibytes(decodedBytes)} of at most ${mebibytes(MAX_IMAGE_BYTES)}`)
  }
  // What Zstandard is told to make room for: at most RGBA, or blocks of 4 x 4 texels in 16 bytes each.
  const blockBytes = 16 * Math.ceil(width / 4) * Math.ceil(height / 4) * count
  const most = vkFormat === VK_FORMAT_UNDEFINED ? blockBytes : decodedBytes
  if (scheme === KHR_SUPERCOMPRESSION_ZSTD && view.getBigUint64(96, true) > most) {
    throw new Error('its first level is larger than its image')
  }
  return { vkFormat, width, height, count, decodedBytes }
}

const mebibytes = (bytes: number) => `${Math.ceil(bytes / 2 ** 20)} MiB`
