/** Hashes an integer by the 32-bit finaliser of MurmurHash3 (A. Appleby 2011, public domain). Returns an integer, 0..2^32 - 1. */
export function hash32(x: number): number {
  let h = x | 0
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b)
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35)
  return (h ^ (h >>> 16)) >>> 0
}
