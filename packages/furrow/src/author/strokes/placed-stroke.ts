import type { Stroke } from './document.ts'
import { type LaidStroke, reachOf } from './lay-out.ts'
import { LineGrid } from './line-grid.ts'

/** Stroke that is laid on the skin. */
export interface PlacedStroke {
  stroke: Stroke
  laid: readonly LaidStroke[]
  /** Bounding box of the space within reach of the stroke, in millimetres: lowest x, y and z, then highest. */
  box: Float64Array
}

export function placeOf(laid: readonly LaidStroke[]): Omit<PlacedStroke, 'stroke'> {
  return { laid, box: boxAround(laid, reachOf) }
}

/**
 * Returns the bounding box of lines, widened by a margin for each line.
 *
 * @returns lowest x, y and z, then highest.
 */
export function boxAround<Line extends { points: Float64Array }>(
  lines: readonly Line[],
  marginOf: (line: Line) => number,
): Float64Array {
  const box = Float64Array.of(Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity)
  for (const line of lines) {
    const margin = marginOf(line)
    for (const [i, value] of line.points.entries()) {
      box[i % 3] = Math.min(box[i % 3], value - margin)
      box[3 + (i % 3)] = Math.max(box[3 + (i % 3)], value + margin)
    }
  }
  return box
}

/** Whether two boxes overlap. */
export function overlap(a: Float64Array, b: Float64Array): boolean {
  return a[0] <= b[3] && b[0] <= a[3] && a[1] <= b[4] && b[1] <= a[4] && a[2] <= b[5] && b[2] <= a[5]
}

export function gridOf(strokes: readonly PlacedStroke[]): LineGrid {
  const laid = laidOf(strokes)
  return new LineGrid(laid, laid.map(reachOf))
}

export function laidOf(strokes: readonly PlacedStroke[]): LaidStroke[] {
  return strokes.flatMap(({ laid }) => laid)
}
