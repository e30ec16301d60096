import { nativeZstd } from '#zstd'
import { checkContentSize, type Zstd } from './zstd-frame.ts'

/** Compression level, 1 to 22. Higher levels take far longer and save only a few percent. */
const LEVEL = 12

let loading: Promise<Zstd> | undefined

/** Returns Zstandard functions: those of Node 22.15 or later, otherwise those of a WebAssembly module. */
export function zstd(): Promise<Zstd> {
  // Loads the WebAssembly module only once, because a second initialisation breaks the first instance.
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
