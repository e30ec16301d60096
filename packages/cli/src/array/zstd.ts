import zlib from 'node:zlib'

/** Zstandard (RFC 8878). */
export interface Zstd {
  compress(data: Uint8Array): Uint8Array<ArrayBuffer>
  /** Throws Error where the data is not as long as `size`, as far as possible before anything is allocated. */
  decompress(data: Uint8Array, size: number): Uint8Array
}

/** Of 1 to 22; higher levels take far longer for a few percent. */
const LEVEL = 12

let loading: Promise<Zstd> | undefined

/** Node's own Zstandard (22.15 and later), or WebAssembly on older versions. */
export function zstd(): Promise<Zstd> {
  // Only once: a second initialisation of the WebAssembly breaks the first.
  loading ??= Promise.resolve(nodeZstd() ?? wasmZstd())
  return loading
}

/** The types of the oldest supported Node do not have these. */
interface ZlibWithZstd {
  constants: { ZSTD_c_compressionLevel: number }
  zstdCompressSync(data: Uint8Array, options: { params: Record<number, number> }): Uint8Array
  zstdDecompressSync(data: Uint8Array, options: { maxOutputLength: number }): Uint8Array
}

function nodeZstd(): Zstd | undefined {
  if (!('zstdCompressSync' in zlib)) return undefined
  const { constants, zstdCompressSync, zstdDecompressSync } = zlib as unknown as ZlibWithZstd
  const params = { [constants.ZSTD_c_compressionLevel]: LEVEL }
  return {
    compress: (data) => new Uint8Array(zstdCompressSync(data, { params })),
    decompress: (data, size) => {
      checkContentSize(data, size)
      return new Uint8Array(zstdDecompressSync(data, { maxOutputLength: size }))
    },
  }
}

async function wasmZstd(): Promise<Zstd> {
  const { compress, decompress, init } = await import('@bokuweb/zstd-wasm')
  await init()
  return {
    compress: (data) => new Uint8Array(compress(data, LEVEL)),
    decompress: (data, size) => {
      checkContentSize(data, size)
      return decompress(data, { defaultHeapSize: size })
    },
  }
}

/** Checks the size that the header of the first frame gives (RFC 8878, 3.1.1.1), where it gives one. */
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
