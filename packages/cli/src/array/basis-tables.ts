import type { KTX2Container } from 'ktx-parse'

/** Where a KTX 2 file says at which byte its global data begins (KTX 2.0, 3.1: after twelve bytes, nine words, four words). */
const GLOBAL_DATA_OFFSET = 64
/** Bytes of the head of the ETC1S tables, and of the description of one image in them (KTX 2.0, 3.12.2). */
const HEAD = 20
const IMAGE = 20

/**
 * Reads the ETC1S tables of an array again: ktx-parse (1.1 and 2.0) expects one image per level in them and takes the
 * descriptions of the other layers for codebooks, so that what it writes cannot be decoded any more.
 */
export function mendBasisTables(container: KTX2Container, bytes: Uint8Array): void {
  const tables = container.globalData
  const images = Math.max(container.levelCount, 1) * Math.max(container.layerCount, 1)
  if (!tables || tables.imageDescs.length === images) return
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  const start = Number(view.getBigUint64(GLOBAL_DATA_OFFSET, true))
  tables.imageDescs = Array.from({ length: images }, (_, i) => {
    const word = (k: number) => view.getUint32(start + HEAD + i * IMAGE + 4 * k, true)
    return {
      imageFlags: word(0),
      rgbSliceByteOffset: word(1),
      rgbSliceByteLength: word(2),
      alphaSliceByteOffset: word(3),
      alphaSliceByteLength: word(4),
    }
  })
  let at = start + HEAD + images * IMAGE
  const next = (length: number) => {
    at += length
    return bytes.slice(at - length, at)
  }
  tables.endpointsData = next(tables.endpointsData.length)
  tables.selectorsData = next(tables.selectorsData.length)
  tables.tablesData = next(tables.tablesData.length)
  tables.extendedData = next(tables.extendedData.length)
}
