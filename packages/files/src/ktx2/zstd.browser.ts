import type { Zstd } from './zstd-frame.ts'

/** Returns undefined: browsers have no Zstandard API. */
export function nativeZstd(_level: number): Zstd | undefined {
  return undefined
}
