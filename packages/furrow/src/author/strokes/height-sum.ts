import { power } from '../../math/elementary.ts'
import { lerp } from '../../math/scalar.ts'
import type { Metric } from '../metric.ts'
import type { CrossSection, LaidStroke } from './lay-out.ts'
import { bankAt, valleyAt } from './profile.ts'

/**
 * Exponents of the norms that join strokes. Valleys: (a^6 + b^6)^(1/6) is close to the maximum, at most 12% more. Crossing valleys are as
 * deep as the deeper one, not the sum. Banks: (a^2 + b^2)^(1/2) merges the banks of two neighbouring lines into one bulge.
 */
const JOIN = { valleys: 6, banks: 2 } as const
/** Fraction of the light lost in a valley, per depth in half widths, and its maximum. */
const SHADE = 1.1
const MAX_SHADE = 0.75

/**
 * Minimum half width of a drawn valley, in half texels. Narrower valleys would alias into dotted lines: full depth at texel centres, half
 * depth between them.
 */
const NARROWEST = 3

/** Sums the strokes at a texel in order: valleys with valleys and banks with banks (see JOIN), then subtracts. */
export class HeightSum {
  /** Sums of powers of depths and of heights. */
  valleys = 0
  banks = 0
  /** Darkest shade of the strokes. */
  shade = 0

  clear(): void {
    this.valleys = this.banks = this.shade = 0
  }

  /** Adds the powers of a depth and of a height. */
  add(valley: number, bank: number): void {
    this.valleys += valley
    this.banks += bank
  }

  /** Millimetres above (+) or below (-) the smooth skin. */
  get height(): number {
    return Math.fround(Math.sqrt(this.banks) - power(this.valleys, 1 / JOIN.valleys))
  }

  /** Occlusion: 255 = open to the light. */
  get open(): number {
    return Math.round(255 * (1 - Math.min(MAX_SHADE, Math.fround(this.shade))))
  }
}

/** Powers that a stroke adds at a texel. */
export interface StrokePowers {
  valley: number
  bank: number
}

/**
 * Adds a stroke to the sum of a texel; see `LineVisitor` for the other parameters.
 *
 * @param sharpest half the texel's size: the limit of a valley's sharpness, and the unit of NARROWEST.
 * @param out receives the added powers.
 */
export function addStroke(
  sum: HeightSum,
  stroke: LaidStroke,
  distance: number,
  segment: number,
  t: number,
  side: number,
  sharpest: number,
  out?: StrokePowers,
): void {
  const depth = lerp(stroke.depths[segment], stroke.depths[segment + 1], t)
  const halfWidth = lerp(stroke.halfWidths[segment], stroke.halfWidths[segment + 1], t)
  addSection(sum, stroke, depth, halfWidth, distance, side, sharpest, out)
}

/** Adds a point of a stroke's cross-section to a sum; see `addStroke`. */
export function addSection(
  sum: HeightSum,
  { shoulder, banks, lean, softness }: CrossSection,
  depth: number,
  halfWidth: number,
  distance: number,
  side: number,
  sharpest: number,
  out?: StrokePowers,
): void {
  const right = 0.5 + 0.5 * side
  const wall = halfWidth * (1 + lean * side)
  const widened = Math.max(1, (NARROWEST * sharpest) / wall)
  const valley = depth * valleyAt(distance / wall, Math.max(softness, sharpest / (widened * wall)), widened)
  const reach = lerp(banks[0], banks[1], right)
  // Round the edge where the bank rises from the bottom.
  const rounded = sharpest > 0 ? distance / Math.sqrt(distance * distance + sharpest * sharpest) : 1
  const bank = depth * rounded * bankAt(distance / halfWidth, reach, lerp(shoulder[0], shoulder[1], right))
  sum.shade = Math.max(sum.shade, (valley / (widened * halfWidth)) * SHADE)
  const cube = valley * valley * valley
  sum.add(cube * cube, bank * bank)
  if (!out) return
  out.valley = cube * cube
  out.bank = bank * bank
}

/** Returns half the longer side of a texel in millimetres. */
export function sharpestAt({ uu, vv, width, height }: Metric, texel: number): number {
  return Math.sqrt(Math.max(uu[texel] / width ** 2, vv[texel] / height ** 2)) / 2
}
