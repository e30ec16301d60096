import zlib from 'node:zlib'

/** Zstandard (RFC 8878). */
export interface Zstd {
  compress(data: Uint8Array): Uint8Array<ArrayBuffer>
  decompress(data: Uint8Array): Uint8Array
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
  zstdDecompressSync(data: Uint8Array): Uint8Array
}

function nodeZstd(): Zstd | undefined {
  if (!('zstdCompressSync' in zlib)) return undefined
  const { constants, zstdCompressSync, zstdDecompressSync } = zlib as unknown as ZlibWithZstd
  const params = { [constants.ZSTD_c_compressionLevel]: LEVEL }
  return {
    compress: (data) => new Uint8Array(zstdCompressSync(data, { params })),
    decompress: (data) => new Uint8Array(zstdDecompressSync(data)),
  }
}

async function wasmZstd(): Promise<Zstd> {
  const { compress, decompress, init } = await import('@bokuweb/zstd-wasm')
  await init()
  return { compress: (data) => new Uint8Array(compress(data, LEVEL)), decompress: (data) => decompress(data) }
}
