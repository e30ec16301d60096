import type { Zstd } from '../../array/zstd.ts'

/** Browsers have none that a page can call. */
export function nativeZstd(_level: number): Zstd | undefined {
  return undefined
}
