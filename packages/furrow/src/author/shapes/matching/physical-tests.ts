import { clamp } from '../../../math/scalar.ts'
import type { ShapeLabel } from '../families.ts'
import { GRID, LID_ROWS, LID_SAMPLES, LIP_SAMPLES } from '../fields/sample-points.ts'
import type { ShapeField } from '../fields/shape-fields.ts'

/** Increase of the score of a blink if the lids meet. */
const CLOSED_LIDS = 0.5
/** Maximum change of the score of a smile or a dimple, depending on the motion of the mouth's corner. */
const RISING_CORNER = 0.12

/** Index of the first sample along the upper lip. */
const UPPER_LIP = GRID.length + LID_ROWS.length * LID_SAMPLES.length
/** Index in a row of lip samples at which the samples near the left corner of the mouth start. */
const CORNER = 14

/** Tests whether a blendshape has a motion that is typical for an ARKit label, and returns the change of the label's score. */
export function physicalScore(label: ShapeLabel, shape: ShapeField): number {
  return lidScore(label, shape) + cornerScore(label, shape)
}

function lidScore({ family, side }: ShapeLabel, { closes: [left, right] }: ShapeField): number {
  if (family !== 'eyeBlink') return 0
  const isClosed = side === 'both' ? left && right : side === 'left' ? left : right
  return isClosed ? CLOSED_LIDS : 0
}

/** Compares how far a corner of the mouth rises and moves outwards: it mostly rises in a smile, and mostly moves outwards in a dimple. */
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
