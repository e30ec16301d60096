/**
 * Wraps a texture coordinate into 0..1, for maps that repeat. A coordinate already within 0..1, both ends included, stays exactly as
 * it is.
 */
export function repeat(coordinate: number): number {
  return coordinate - Math.max(Math.ceil(coordinate) - 1, Math.min(Math.floor(coordinate), 0))
}
