import { power } from '../../math/elementary.ts'
import { lerp } from '../../math/scalar.ts'
import type { Metric } from '../metric.ts'
import type { CrossSection, LaidStroke } from './lay-out.ts'
import { bankAt, valleyAt } from './profile.ts'

/**
 * Exponents of the norms that combine overlapping strokes. Two valleys of depths a and b have the depth `(a^6 + b^6)^(1/6)`, at most 12%
 * more than the deeper one, because crossing wrinkles do not add up. Two banks of heights a and b have the height `sqrt(a^2 + b^2)`, so that
 * the banks between two neighbouring wrinkles merge into one bulge.
 */
const JOIN = { valleys: 6, banks: 2 } as const
/** Fraction of the light lost at the bottom of a valley whose depth equals its half width. */
const SHADE = 1.1
/** Maximum fraction of the light lost in a valley. */
const MAX_SHADE = 0.75

/**
 * Minimum half width of a drawn valley, in half texels. Narrower valleys would look like dotted lines, because their bottom has full depth
 * at a texel's centre and half the depth between two texels.
 */
const NARROWEST = 3

/** Combines the strokes at a texel: valleys with valleys, and banks with banks (see `JOIN`). The height is banks minus valleys. */
export class HeightSum {
  /** Sum of the valleys' depths to the power `JOIN.valleys`. */
  valleys = 0
  /** Sum of the banks' heights to the power `JOIN.banks`. */
  banks = 0
  /** Maximum fraction of the light lost to one stroke. */
  shade = 0

  clear(): void {
    this.valleys = this.banks = this.shade = 0
  }

  /** Adds a depth to the power `JOIN.valleys` and a height to the power `JOIN.banks`. */
  add(valley: number, bank: number): void {
    this.valleys += valley
    this.banks += bank
  }

  /** Millimetres above (+) or below (-) the smooth skin. */
  get height(): number {
    return Math.fround(Math.sqrt(this.banks) - power(this.valleys, 1 / JOIN.valleys))
  }

  /** Occlusion byte: 255 = unoccluded. */
  get open(): number {
    return Math.round(255 * (1 - Math.min(MAX_SHADE, Math.fround(this.shade))))
  }
}

/** Numbers that a stroke adds to a `HeightSum`. */
export interface StrokePowers {
  valley: number
  bank: number
}

/**
 * Adds a stroke to the sum of a texel. The parameters `distance`, `segment`, `t` and `side` are those of `LineVisitor`.
 *
 * @param sharpest half the texel's size in millimetres. Valleys and banks are rounded by this radius, and it is the unit of `NARROWEST`.
 * @param out receives the added numbers.
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

/** Adds one point of a stroke's cross-section to a sum. The parameters are those of `addStroke`. */
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
