import type { FaceRng } from '../anatomy/face-rng.ts'
import type { ChartPoint } from '../surface/head-chart.ts'

/** Line of raised or lowered skin on the head's chart. */
export interface BulgeLine {
  path: readonly ChartPoint[]
  /** Full width in millimetres. */
  width: number
  /** Height above the skin at full activation, in millimetres. Negative: depth of a groove. */
  height: number
  /** Heights along the line as fractions of `height`, 0..1, evenly spaced. */
  heights?: readonly number[]
  /** Asymmetry, -0.9..0.9. Positive values make the side on the left of the path steeper, as seen from outside. */
  lean?: number
  /** Lengths of the fade-in and the fade-out, as fractions of the line's length. */
  taper: readonly [start: number, end: number]
}

/** Skin of a face that rises or sinks with age. It has its own area of influence. */
export interface BulgeRegion {
  /** Name of the area. */
  name: string
  /** Lines. If the mesh has no skin along the first line, the region gets no bulge. */
  lines: readonly BulgeLine[]
}

/** Returns a random factor on heights, because no two bulges of a person are equal. */
export function unevenness(rng: FaceRng): number {
  return rng.uniform(0.85, 1.1)
}
