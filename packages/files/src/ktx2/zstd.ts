import { nativeZstd } from '#zstd'
import { checkContentSize, type Zstd } from './zstd-frame.ts'

/** Compression level, 1 to 22. Higher levels take far longer and save a few percent. */
const LEVEL = 12

let loading: Promise<Zstd> | undefined

/** Returns Node's Zstandard functions (22.15 and later), or a WebAssembly module on older versions and in browsers. */
export function zstd(): Promise<Zstd> {
  // Initialising the WebAssembly module twice breaks the first instance.
  loading ??= Promise.resolve(nativeZstd(LEVEL) ?? wasmZstd())
  return loading
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
