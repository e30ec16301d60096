import { BLOOD_AT_REST } from '../core/blood.ts'
import type { GrayImage } from '../core/types.ts'
import { exp } from '../math/elementary.ts'
import { clamp } from '../math/scalar.ts'
import type { HeightMap } from './strokes/height.ts'

/** Optical depth of the strongest flush in the green channel: the amplitude of layers with drawn blood. */
export const BLOOD_AMPLITUDE = 0.35
/** Maximum tone of a valley, as a fraction of the amplitude, and the depth in millimetres that reaches 63% of it. */
const VALLEY = 0.3
const VALLEY_DEPTH = 0.7

/** Draws the blood of lines: valleys are slightly darker. */
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
 * Replaces the valley tones in a layer's blood when its lines change. Everything else, such as a flush, stays.
 *
 * @param blood map with the old lines.
 * @param before `valleyBlood` of the old lines; undefined if they had none.
 * @param after `valleyBlood` of the new lines. All maps have the same size.
 */
export function changedBlood(blood: GrayImage, before: GrayImage | undefined, after: GrayImage): GrayImage {
  const tone = (i: number) => after.data[i] - (before ? before.data[i] : BLOOD_AT_REST)
  const data = blood.data.map((value, i) => clamp(value + tone(i), 0, 255))
  return { ...blood, data }
}
