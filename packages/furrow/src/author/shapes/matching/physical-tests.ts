import { clamp } from '../../../math/scalar.ts'
import type { ShapeLabel } from '../families.ts'
import { GRID, LID_ROWS, LID_SAMPLES, LIP_SAMPLES } from '../fields/sample-points.ts'
import type { ShapeField } from '../fields/shape-fields.ts'

/** Scores that outweigh templates, because they are direct evidence of the motion. */
const CLOSED_LIDS = 0.5
const RISING_CORNER = 0.12

/** First sample of the upper lip's row, and first sample of a row near the left corner. */
const UPPER_LIP = GRID.length + LID_ROWS.length * LID_SAMPLES.length
const CORNER = 14

/** Tests a shape's motion for a label and returns the change of its score. */
export function physicalScore(label: ShapeLabel, shape: ShapeField): number {
  return lidScore(label, shape) + cornerScore(label, shape)
}

/** Lids that meet are a blink. */
function lidScore({ family, side }: ShapeLabel, { closes: [left, right] }: ShapeField): number {
  if (family !== 'eyeBlink') return 0
  const isClosed = side === 'both' ? left && right : side === 'left' ? left : right
  return isClosed ? CLOSED_LIDS : 0
}

/** A smile raises the corner of the mouth more than it draws it outwards; a dimple does the opposite. */
function cornerScore({ family, side }: ShapeLabel, { field, strength }: ShapeField): number {
  if (family !== 'mouthSmile' && family !== 'mouthDimple') return 0
  const sign = side === 'right' ? -1 : 1
  let [out, rise] = [0, 0]
  for (let k = CORNER; k < LIP_SAMPLES; k++) {
    const sample = UPPER_LIP + (sign > 0 ? k : LIP_SAMPLES - 1 - k)
    out += (sign * field[3 * sample]) / (LIP_SAMPLES - CORNER)
    rise += field[3 * sample + 1] / (LIP_SAMPLES - CORNER)
  }
  if (!(rise > 0 && out > 0)) return 0
  const part = clamp((rise + out) / (0.5 * strength), 0, 1)
  const steepness = part * clamp((rise / out - 1) / 0.3, -1, 1)
  return family === 'mouthSmile' ? RISING_CORNER * steepness : -RISING_CORNER * steepness
}
