import { CENTRAL, isCentral, SHIFTED, SIDED } from '../families.ts'
import { MIRRORED, SAMPLES } from '../fields/sample-points.ts'
import type { TemplateHead, TemplateShape } from './templates.ts'

/** Families of ARKit shapes. The code of a family is its index. */
const FAMILIES: readonly string[] = [...SIDED, ...CENTRAL, ...SHIFTED]
/** Quantisation steps per unit of a shape's strength, and of the largest absolute coordinate in its displacement field. */
const STEPS = 10_000

// Shapes in `CENTRAL` are symmetric and store only one half of the face. Other shapes store the displacements of all samples.
const ALL = Array.from({ length: SAMPLES }, (_, i) => i)
const HALF = ALL.filter((i) => i <= MIRRORED[i])

/**
 * Encodes the shapes of a reference head as bytes. The weights of the samples come first. For each shape, the family, the strength, the
 * largest absolute coordinate in the displacement field, and the field follow. Coordinates of a field are relative to the largest one. They
 * have 8 bits on a square-root scale, which has finer steps near 0. A run of zeros is stored as a zero and the length of the run.
 */
export function encodeHead({ weights, shapes }: TemplateHead): Uint8Array {
  const bytes: number[] = Array.from(weights, (weight) => Math.round(255 * weight))
  for (const { family, field, strength } of shapes) {
    const largest = field.reduce((most, x) => Math.max(most, Math.abs(x)), 0)
    bytes.push(FAMILIES.indexOf(family), ...word(strength), ...word(largest))
    const samples = samplesOf(family)
    for (let k = 0; k < 3; k++) {
      let zeros = 0
      for (const i of samples) {
        const value = field[3 * i + k]
        const code = Math.round(127 * Math.sign(value) * Math.sqrt(Math.abs(value) / largest))
        if (code === 0 && zeros < 255) {
          zeros++
          continue
        }
        if (zeros > 0) bytes.push(0, zeros)
        zeros = 0
        if (code === 0) zeros = 1
        else bytes.push(code & 255)
      }
      if (zeros > 0) bytes.push(0, zeros)
    }
  }
  return Uint8Array.from(bytes)
}

export function decodeHead(bytes: Uint8Array): TemplateHead {
  const weights = Float64Array.from(bytes.subarray(0, SAMPLES), (byte) => byte / 255)
  const shapes: TemplateShape[] = []
  let at = SAMPLES
  const next = () => bytes[at++]
  const nextWord = () => (next() + 256 * next()) / STEPS
  while (at < bytes.length) {
    const family = FAMILIES[next()]
    const [strength, largest] = [nextWord(), nextWord()]
    const field = new Float64Array(3 * SAMPLES)
    const samples = samplesOf(family)
    for (let k = 0; k < 3; k++) {
      for (let n = 0; n < samples.length; ) {
        const code = (next() << 24) >> 24
        if (code === 0) {
          n += next()
          continue
        }
        const i = samples[n++]
        const value = largest * Math.sign(code) * (code / 127) ** 2
        field[3 * i + k] = value
        if (isCentral(family))
          field[3 * MIRRORED[i] + k] = i === MIRRORED[i] && k === 0 ? 0 : k === 0 ? -value : value
      }
    }
    shapes.push({ family, field, strength })
  }
  return { weights, shapes }
}

function samplesOf(family: string): readonly number[] {
  return isCentral(family) ? HALF : ALL
}

function word(value: number): [number, number] {
  const steps = Math.min(65_535, Math.round(STEPS * value))
  return [steps & 255, steps >> 8]
}
