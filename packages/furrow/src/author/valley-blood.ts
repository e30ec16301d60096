import { BLOOD_AT_REST } from '../core/blood.ts'
import type { GrayImage } from '../core/types.ts'
import { exp } from '../math/elementary.ts'
import { clamp } from '../math/scalar.ts'
import type { HeightMap } from './strokes/height.ts'

/** Optical depth in green of the strongest flush: the amplitude of a layer whose blood is drawn. */
export const BLOOD_AMPLITUDE = 0.35
/** Deepest tone of a valley, as a fraction of the amplitude, and the millimetres of depth at which it has 63% of it. */
const VALLEY = 0.3
const VALLEY_DEPTH = 0.7

/** The blood of lines: valleys are a little deeper in tone. */
export function valleyBlood({ width, height, data }: HeightMap): GrayImage {
  const tones = new Uint8Array(data.length).fill(BLOOD_AT_REST)
  for (let i = 0; i < data.length; i++)
    if (data[i] < 0) tones[i] = bloodByte(VALLEY * (1 - exp(data[i] / VALLEY_DEPTH)))
  return { width, height, data: tones }
}

/** @param amount -1..1. */
export function bloodByte(amount: number): number {
  return BLOOD_AT_REST + Math.round((255 - BLOOD_AT_REST) * clamp(amount, -1, 1))
}

/**
 * The blood of a layer whose lines are other ones: what is not the tone of its valleys, such as a flush, stays.
 *
 * @param blood the map with the old lines.
 * @param before that of the old lines alone, see `valleyBlood`; undefined where they had none.
 * @param after that of the new lines. All have the same size.
 */
export function changedBlood(blood: GrayImage, before: GrayImage | undefined, after: GrayImage): GrayImage {
  const tone = (i: number) => after.data[i] - (before ? before.data[i] : BLOOD_AT_REST)
  const data = blood.data.map((value, i) => clamp(value + tone(i), 0, 255))
  return { ...blood, data }
}
