/** Encodes a component of a normal, -1..1, as a byte; 0 becomes 128. */
export function toByte(n: number): number {
  return Math.min(Math.max(Math.round((n + 1) * 127.5), 0), 255)
}
