import zlib from 'node:zlib'
import { checkContentSize, type Zstd } from './zstd-frame.ts'

/** Functions of `node:zlib` that the type definitions of the oldest supported Node lack. */
interface ZlibWithZstd {
  constants: { ZSTD_c_compressionLevel: number }
  zstdCompressSync(data: Uint8Array, options: { params: Record<number, number> }): Uint8Array
  zstdDecompressSync(data: Uint8Array, options: { maxOutputLength: number }): Uint8Array
}

/** Returns Node's Zstandard functions, or undefined in Node before 22.15. */
export function nativeZstd(level: number): Zstd | undefined {
  if (!('zstdCompressSync' in zlib)) return undefined
  const { constants, zstdCompressSync, zstdDecompressSync } = zlib as unknown as ZlibWithZstd
  const params = { [constants.ZSTD_c_compressionLevel]: level }
  return {
    compress: (data) => new Uint8Array(zstdCompressSync(data, { params })),
    decompress: (data, size) => {
      checkContentSize(data, size)
      return new Uint8Array(zstdDecompressSync(data, { maxOutputLength: size }))
    },
  }
}
