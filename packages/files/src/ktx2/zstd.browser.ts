import type { Zstd } from './zstd-frame.ts'

/** Browsers have none that a page can call. */
export function nativeZstd(_level: number): Zstd | undefined {
  return undefined
}
