import type { Zstd } from './zstd-frame.ts'

/** Returns undefined, because browsers have no Zstandard API. */
export function nativeZstd(_level: number): Zstd | undefined {
  return undefined
}
