/** Zstandard compressor and decompressor (RFC 8878). */
export interface Zstd {
  compress(data: Uint8Array): Uint8Array<ArrayBuffer>
  /**
   * Throws if the decompressed length is not `size`. Checks the length in the frame header before it allocates memory.
   */
  decompress(data: Uint8Array, size: number): Uint8Array
}

/**
 * Throws if the first frame's header has a content size other than `size`. This field is optional (RFC 8878, 3.1.1.1).
 */
export function checkContentSize(data: Uint8Array, size: number): void {
  const view = new DataView(data.buffer, data.byteOffset, data.length)
  if (data.length < 18 || view.getUint32(0, true) !== 0xfd2fb528)
    throw new Error('its Zstandard data is damaged')
  const descriptor = data[4]
  const isSingleSegment = (descriptor & 0x20) !== 0
  const dictionaryBytes = [0, 1, 2, 4][descriptor & 3]
  const at = 5 + (isSingleSegment ? 0 : 1) + dictionaryBytes
  const flag = descriptor >> 6
  if (flag === 0 && !isSingleSegment) return
  const content = [
    data[at],
    view.getUint16(at, true) + 256,
    view.getUint32(at, true),
    view.getBigUint64(at, true),
  ][flag]
  if (Number(content) !== size) throw new Error(`it has ${content} bytes instead of ${size}`)
}
