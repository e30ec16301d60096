/**
 * A texture coordinate less its whole numbers where it lies outside 0..1, for maps that repeat there; within 0..1, both ends
 * included, itself.
 */
export function repeat(coordinate: number): number {
  return coordinate - Math.max(Math.ceil(coordinate) - 1, Math.min(Math.floor(coordinate), 0))
}
