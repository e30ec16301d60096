import { compress, decompress, init } from '@bokuweb/zstd-wasm'

/** Of 1 to 22; higher ones take far longer for a few percent. */
const LEVEL = 12

let ready: Promise<void> | undefined

/** Zstandard (RFC 8878) from WebAssembly: Node has it only from version 22.15 on. */
export async function zstd() {
  // Once only: a second start breaks the first.
  ready ??= init()
  await ready
  return {
    compress: (data: Uint8Array) => compress(data, LEVEL),
    decompress: (data: Uint8Array) => decompress(data),
  }
}
