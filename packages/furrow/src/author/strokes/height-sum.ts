import { lerp } from '../../math/scalar.ts'
import type { Metric } from '../metric.ts'
import type { LaidStroke } from './lay-out.ts'
import { profile } from './profile.ts'

/**
 * Exponent of the smooth maximum that joins strokes: (a^6 + b^6)^(1/6) is the larger of two, at most 12% more where they are
 * equal. Valleys that cross are as deep as the deeper one, not as both together.
 */
const JOIN = 6
/** Fraction of the light that a valley loses, per depth in half widths, and at most. */
const SHADE = 1.1
const MAX_SHADE = 0.75

/** Joins what strokes give to a texel, in their order: valleys with valleys and banks with banks (see JOIN), then added. */
export class HeightSum {
  /** Sums of powers of heights. */
  valleys = 0
  banks = 0
  /** The darkest of the strokes. */
  shade = 0

  clear(): void {
    this.valleys = this.banks = this.shade = 0
  }

  /** @param power of a height, with its sign. */
  add(power: number): void {
    if (power < 0) this.valleys -= power
    else this.banks += power
  }

  /** In millimetres above (+) or below (-) the smooth skin. */
  get height(): number {
    return Math.fround(this.banks ** (1 / JOIN) - this.valleys ** (1 / JOIN))
  }

  /** 255 = open to the light. */
  get open(): number {
    return Math.round(255 * (1 - Math.min(MAX_SHADE, Math.fround(this.shade))))
  }
}

/**
 * Adds a stroke at a texel to a sum; the parameters are those of `LineVisitor`.
 *
 * @param sharpest half the size of the texel: no valley is drawn sharper.
 * @returns the power of its height that was added, with its sign.
 */
export function addStroke(
  sum: HeightSum,
  { depths, halfWidths, shoulder, softness }: LaidStroke,
  distance: number,
  segment: number,
  t: number,
  side: number,
  sharpest: number,
): number {
  const depth = lerp(depths[segment], depths[segment + 1], t)
  if (depth === 0) return 0
  const halfWidth = lerp(halfWidths[segment], halfWidths[segment + 1], t)
  const raised = lerp(shoulder[0], shoulder[1], 0.5 + 0.5 * side)
  const roundness = Math.max(softness, sharpest / halfWidth)
  const height = depth * profile(distance / halfWidth, raised, roundness)
  const square = height * height
  const power = Math.sign(height) * square * square * square
  if (height < 0) sum.shade = Math.max(sum.shade, (-height / halfWidth) * SHADE)
  sum.add(power)
  return power
}

/** Half the longer side of a texel in millimetres. */
export function sharpestAt({ uu, vv, width, height }: Metric, texel: number): number {
  return Math.sqrt(Math.max(uu[texel] / width ** 2, vv[texel] / height ** 2)) / 2
}
