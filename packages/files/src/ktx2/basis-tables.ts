import type { KTX2Container } from 'ktx-parse'

/** Byte offset of `sgdByteOffset` in the KTX 2 header (KTX 2.0, 3.1). This field locates the ETC1S tables. */
const GLOBAL_DATA_OFFSET = 64
/** Size of the header that starts the ETC1S tables, and size of one image description, bytes (KTX 2.0, 3.12.2). */
const HEADER_BYTES = 20
const IMAGE_BYTES = 20

/**
 * Corrects the ETC1S tables that ktx-parse (1.1 and 2.0) reads from a texture array. ktx-parse expects one image
 * description per level, but there is one per level and layer. It would read the other descriptions as codebooks and
 * write a file that cannot be decoded.
 *
 * @param container result of reading `bytes` with ktx-parse. The function replaces its tables.
 */
export function fixBasisTables(container: KTX2Container, bytes: Uint8Array): void {
  const tables = container.globalData
  const images = Math.max(container.levelCount, 1) * Math.max(container.layerCount, 1)
  if (!tables || tables.imageDescs.length === images) return
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  const start = Number(view.getBigUint64(GLOBAL_DATA_OFFSET, true))
  tables.imageDescs = Array.from({ length: images }, (_, i) => {
    const word = (k: number) => view.getUint32(start + HEADER_BYTES + i * IMAGE_BYTES + 4 * k, true)
    return {
      imageFlags: word(0),
      rgbSliceByteOffset: word(1),
      rgbSliceByteLength: word(2),
      alphaSliceByteOffset: word(3),
      alphaSliceByteLength: word(4),
    }
  })
  let offset = start + HEADER_BYTES + images * IMAGE_BYTES
  const next = (length: number) => {
    offset += length
    return bytes.slice(offset - length, offset)
  }
  tables.endpointsData = next(tables.endpointsData.length)
  tables.selectorsData = next(tables.selectorsData.length)
  tables.tablesData = next(tables.tablesData.length)
  tables.extendedData = next(tables.extendedData.length)
}
