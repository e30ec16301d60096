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
  const box = Float64Array.of(Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity)
  for (const line of laid) {
    const reach = reachOf(line)
    for (const [i, value] of line.points.entries()) {
      box[i % 3] = Math.min(box[i % 3], value - reach)
      box[3 + (i % 3)] = Math.max(box[3 + (i % 3)], value + reach)
    }
  }
  return { laid, box }
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
