import { power } from '../../math/elementary.ts'
import { lerp } from '../../math/scalar.ts'
import type { Metric } from '../metric.ts'
import type { CrossSection, LaidStroke } from './lay-out.ts'
import { bankAt, bulgeAt, valleyAt } from './profile.ts'

/**
 * Exponents of the norms that combine overlapping strokes (wrinkles). A stroke has a valley and raised banks on both sides. Two valleys of
 * depths a and b combine to the depth `(a^6 + b^6)^(1/6)`, because the depths of crossing wrinkles do not add up. This depth exceeds that of
 * the deeper valley by at most 12%. Two banks of heights a and b combine to the height `sqrt(a^2 + b^2)`: banks between two wrinkles merge
 * into one bulge. The heights of bulges (strokes with a negative depth) are added to the result, because wrinkles follow the shape of bulges.
 */
const JOIN = { valleys: 6, banks: 2 } as const
/** Fraction of the light that a valley loses if it is as deep as half of its width. The loss is proportional to this ratio, up to `MAX_SHADE`. */
const SHADE = 1.1
/** Maximum fraction of the light lost in a valley. */
const MAX_SHADE = 0.75

/**
 * Minimum half width of a drawn valley, in half texels. A narrower valley would look like a dotted line: deep where its bottom crosses the
 * centre of a texel, and half as deep where its bottom passes between two texels.
 */
const NARROWEST = 3

/** Combines all strokes at a texel: valleys with valleys, banks with banks, and bulges with bulges (see `JOIN`). */
export class HeightSum {
  /** Sum of `depth ** JOIN.valleys` of all valleys. */
  valleys = 0
  /** Sum of `height ** JOIN.banks` of all banks. */
  banks = 0
  /** Sum of the heights of all bulges in millimetres. */
  bulges = 0
  /** Fraction of the light, 0..1, that the darkest stroke occludes. */
  shade = 0

  clear(): void {
    this.valleys = this.banks = this.bulges = this.shade = 0
  }

  /** Adds one stroke. */
  add({ valley, bank, bulge }: StrokePowers): void {
    this.valleys += valley
    this.banks += bank
    this.bulges += bulge
  }

  /** Millimetres above (+) or below (-) the smooth skin. */
  get height(): number {
    return Math.fround(Math.sqrt(this.banks) - power(this.valleys, 1 / JOIN.valleys) + this.bulges)
  }

  /** Occlusion byte: 255 = unoccluded. */
  get open(): number {
    return Math.round(255 * (1 - Math.min(MAX_SHADE, Math.fround(this.shade))))
  }
}

/** Numbers that a stroke adds to a `HeightSum`. */
export interface StrokePowers {
  /** `depth ** JOIN.valleys`. */
  valley: number
  /** `height ** JOIN.banks`. */
  bank: number
  /** Height in millimetres. */
  bulge: number
}

/** Scratch, reused per stroke. */
const POWERS: StrokePowers = { valley: 0, bank: 0, bulge: 0 }

/**
 * Adds a stroke to the sum of a texel. `LineVisitor` describes the parameters `distance`, `segment`, `t` and `side`.
 *
 * @param sharpest half the texel's size in millimetres: the minimum radius of the valley's bottom, and the unit of `NARROWEST`.
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
  out: StrokePowers = POWERS,
): void {
  const depth = lerp(stroke.depths[segment], stroke.depths[segment + 1], t)
  const halfWidth = lerp(stroke.halfWidths[segment], stroke.halfWidths[segment + 1], t)
  addSection(sum, stroke, depth, halfWidth, distance, side, sharpest, out)
}

/** Does the same as `addStroke`, for a given depth and half width in millimetres. A negative depth is the height of a bulge. */
export function addSection(
  sum: HeightSum,
  { shoulder, banks, lean, softness }: CrossSection,
  depth: number,
  halfWidth: number,
  distance: number,
  side: number,
  sharpest: number,
  out: StrokePowers = POWERS,
): void {
  const right = 0.5 + 0.5 * side
  const wall = halfWidth * (1 + lean * side)
  out.valley = out.bank = out.bulge = 0
  if (depth < 0) {
    out.bulge = -depth * bulgeAt(distance / wall)
    sum.add(out)
    return
  }
  const widened = Math.max(1, (NARROWEST * sharpest) / wall)
  const valley = depth * valleyAt(distance / wall, Math.max(softness, sharpest / (widened * wall)), widened)
  const reach = lerp(banks[0], banks[1], right)
  // The banks of both sides meet in a sharp edge at the bottom of the valley. Round it.
  const rounded = sharpest > 0 ? distance / Math.sqrt(distance * distance + sharpest * sharpest) : 1
  const bank = depth * rounded * bankAt(distance / halfWidth, reach, lerp(shoulder[0], shoulder[1], right))
  sum.shade = Math.max(sum.shade, (valley / (widened * halfWidth)) * SHADE)
  const cube = valley * valley * valley
  out.valley = cube * cube
  out.bank = bank * bank
  sum.add(out)
}

/** Returns half the longer side of a texel in millimetres. */
export function sharpestAt({ uu, vv, width, height }: Metric, texel: number): number {
  return Math.sqrt(Math.max(uu[texel] / width ** 2, vv[texel] / height ** 2)) / 2
}
