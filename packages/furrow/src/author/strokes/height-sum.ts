import { power } from '../../math/elementary.ts'
import { lerp } from '../../math/scalar.ts'
import type { Metric } from '../metric.ts'
import type { CrossSection, LaidStroke } from './lay-out.ts'
import { bankAt, valleyAt } from './profile.ts'

/**
 * Exponents by which strokes are joined. Of valleys (a^6 + b^6)^(1/6) is the larger of two, at most 12% more where they are equal: valleys that
 * cross are as deep as the deeper one, not as both together. Of banks (a^2 + b^2)^(1/2) makes one bulge of those of two neighbouring lines.
 */
const JOIN = { valleys: 6, banks: 2 } as const
/** Fraction of the light that a valley loses, per depth in half widths, and at most. */
const SHADE = 1.1
const MAX_SHADE = 0.75

/**
 * Half the width of the narrowest valley that is drawn, in halves of a texel. Finer ones would be dotted lines: as deep as they are where the
 * bottom meets the centre of a texel, and half as deep between two.
 */
const NARROWEST = 3

/** Joins what strokes give to a texel, in their order: valleys with valleys and banks with banks (see JOIN), then subtracted. */
export class HeightSum {
  /** Sums of powers of depths and of heights. */
  valleys = 0
  banks = 0
  /** The darkest of the strokes. */
  shade = 0

  clear(): void {
    this.valleys = this.banks = this.shade = 0
  }

  /** Adds the powers of a depth and of a height. */
  add(valley: number, bank: number): void {
    this.valleys += valley
    this.banks += bank
  }

  /** In millimetres above (+) or below (-) the smooth skin. */
  get height(): number {
    return Math.fround(Math.sqrt(this.banks) - power(this.valleys, 1 / JOIN.valleys))
  }

  /** 255 = open to the light. */
  get open(): number {
    return Math.round(255 * (1 - Math.min(MAX_SHADE, Math.fround(this.shade))))
  }
}

/** What a stroke gives to a texel, as powers. */
export interface StrokePowers {
  valley: number
  bank: number
}

/**
 * Adds a stroke at a texel to a sum; the parameters are those of `LineVisitor`.
 *
 * @param sharpest half the size of the texel: no valley is drawn sharper, or narrower than NARROWEST of it.
 * @param out takes the powers that were added.
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

/** Adds a point of a stroke's cross-section to a sum, see `addStroke`. */
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
  // A bank would rise from the bottom with an edge: that is rounded too.
  const rounded = sharpest > 0 ? distance / Math.sqrt(distance * distance + sharpest * sharpest) : 1
  const bank = depth * rounded * bankAt(distance / halfWidth, reach, lerp(shoulder[0], shoulder[1], right))
  sum.shade = Math.max(sum.shade, (valley / (widened * halfWidth)) * SHADE)
  const cube = valley * valley * valley
  sum.add(cube * cube, bank * bank)
  if (!out) return
  out.valley = cube * cube
  out.bank = bank * bank
}

/** Half the longer side of a texel in millimetres. */
export function sharpestAt({ uu, vv, width, height }: Metric, texel: number): number {
  return Math.sqrt(Math.max(uu[texel] / width ** 2, vv[texel] / height ** 2)) / 2
}
