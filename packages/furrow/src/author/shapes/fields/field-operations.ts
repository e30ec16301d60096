import { clamp } from '../../../math/scalar.ts'
import { MIRRORED, SAMPLE_U, SAMPLES } from './sample-points.ts'

/**
 * Operations on displacement fields. A field holds the displacement of a blendshape at each sample point (see `sample-points.ts`), packed
 * xyz in face coordinates, with x to the person's left.
 */

/** Returns the displacement field of the mirrored shape. */
export function mirroredField(field: Float64Array): Float64Array {
  const out = new Float64Array(field.length)
  for (let i = 0; i < SAMPLES; i++) {
    const from = 3 * MIRRORED[i]
    out[3 * i] = -field[from]
    out[3 * i + 1] = field[from + 1]
    out[3 * i + 2] = field[from + 2]
  }
  return out
}

/** Returns the left or right half of a field. The displacements fade to 0 across the middle of the face. */
export function halfField(field: Float64Array, side: 'left' | 'right'): Float64Array {
  const sign = side === 'left' ? 1 : -1
  return field.map((value, k) => value * clamp(0.5 + (sign * SAMPLE_U[Math.floor(k / 3)]) / 0.5, 0, 1))
}

export function sumOf(a: Float64Array, b: Float64Array, scale = 1): Float64Array {
  return a.map((value, k) => value + scale * b[k])
}

/** Two unit vectors that describe a displacement field regardless of its strength. Fields are compared by the dot products of these vectors. */
export interface Descriptor {
  /** Weighted displacements. */
  plain: Float64Array
  /** Weighted displacements scaled to the square root of their length, so that small motions count more. */
  compressed: Float64Array
}

export function descriptorOf(field: Float64Array, weights: Float64Array): Descriptor {
  const plain = new Float64Array(field.length)
  const compressed = new Float64Array(field.length)
  for (let i = 0; i < SAMPLES; i++) {
    const [x, y, z] = [field[3 * i], field[3 * i + 1], field[3 * i + 2]]
    const root = Math.sqrt(weights[i])
    const scale = root / Math.sqrt(Math.max(Math.sqrt(x * x + y * y + z * z), 1e-6))
    for (let k = 0; k < 3; k++) {
      plain[3 * i + k] = field[3 * i + k] * root
      compressed[3 * i + k] = field[3 * i + k] * scale
    }
  }
  normalizeAll(plain)
  normalizeAll(compressed)
  return { plain, compressed }
}

/** Returns the similarity of two fields, -1..1: the mean of the dot products of their `plain` and `compressed` vectors. */
export function likeness(a: Descriptor, b: Descriptor): number {
  return (dotAll(a.plain, b.plain) + dotAll(a.compressed, b.compressed)) / 2
}

export function dotAll(a: Float64Array, b: Float64Array): number {
  let sum = 0
  for (let i = 0; i < a.length; i++) sum += a[i] * b[i]
  return sum
}

function normalizeAll(values: Float64Array): void {
  const length = Math.sqrt(dotAll(values, values)) || 1
  for (let i = 0; i < values.length; i++) values[i] /= length
}

/**
 * Returns the fraction of a field's energy (its weighted squared displacements) on the person's left. A strip along the middle of the face
 * does not count. Returns 0.5 if there is no energy on either side.
 */
export function leftFraction(field: Float64Array, weights: Float64Array): number {
  let [left, right] = [0, 0]
  for (let i = 0; i < SAMPLES; i++) {
    const energy = weights[i] * (field[3 * i] ** 2 + field[3 * i + 1] ** 2 + field[3 * i + 2] ** 2)
    if (SAMPLE_U[i] > 0.05) left += energy
    else if (SAMPLE_U[i] < -0.05) right += energy
  }
  return left + right > 0 ? left / (left + right) : 0.5
}
