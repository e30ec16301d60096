/** Wraps a repeating texture coordinate into 0..1. Coordinates from 0 to 1 are unchanged; 1 stays 1. */
export function repeat(coordinate: number): number {
  return coordinate - Math.max(Math.ceil(coordinate) - 1, Math.min(Math.floor(coordinate), 0))
}
