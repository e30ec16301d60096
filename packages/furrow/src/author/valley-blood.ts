import { BLOOD_AT_REST } from '../core/blood.ts'
import type { GrayImage } from '../core/types.ts'
import { exp } from '../math/elementary.ts'
import { clamp } from '../math/scalar.ts'
import type { HeightMap } from './strokes/height.ts'

/** Amplitude of generated blood maps: the optical depth for green light that byte 255 adds. */
export const BLOOD_AMPLITUDE = 0.35
/** Maximum amount of blood in a wrinkle's valley, as a fraction of the amplitude. */
const VALLEY = 0.3
/** Depth in millimetres at which a valley has 63% of `VALLEY`. */
const VALLEY_DEPTH = 0.7

/** Computes a blood map from heights: valleys (negative heights) get more blood, so they look slightly darker. */
export function valleyBlood({ width, height, data }: HeightMap): GrayImage {
  const tones = new Uint8Array(data.length).fill(BLOOD_AT_REST)
  for (let i = 0; i < data.length; i++)
    if (data[i] < 0) tones[i] = bloodByte(VALLEY * (1 - exp(data[i] / VALLEY_DEPTH)))
  return { width, height, data: tones }
}

/** Encodes an amount of blood as a byte of a blood map. The amount is a fraction of the amplitude, -1..1; 0 is skin at rest. */
export function bloodByte(amount: number): number {
  return BLOOD_AT_REST + Math.round((255 - BLOOD_AT_REST) * clamp(amount, -1, 1))
}

/**
 * Updates a layer's blood map after its wrinkle lines changed: subtracts the blood of the old valleys and adds the blood of the new valleys.
 * Other blood in the map stays. All maps have the same size.
 *
 * @param blood map with the blood of the old valleys.
 * @param before result of `valleyBlood` for the old lines; undefined if `blood` contains no blood of valleys.
 * @param after result of `valleyBlood` for the new lines.
 */
export function changedBlood(blood: GrayImage, before: GrayImage | undefined, after: GrayImage): GrayImage {
  const tone = (i: number) => after.data[i] - (before ? before.data[i] : BLOOD_AT_REST)
  const data = blood.data.map((value, i) => clamp(value + tone(i), 0, 255))
  return { ...blood, data }
}
