import type { Curve } from 'furrow'
import { AGES } from 'furrow/internal'
import { type Range, rangeAround } from '../../document/curve.ts'

/** How the input of a curve is drawn and written. */
export interface Axis {
  /** What it measures: `browInnerUp`, `Age`. */
  readonly label: string
  readonly range: Range
  /** From the number in the file to the one that is read. */
  readonly factor: number
  readonly unit: string
}

/** The usual range of an input, and how it is read: radians as degrees, metres as millimetres. */
const KINDS = {
  fraction: { usual: [0, 1], factor: 1, unit: '' },
  age: { usual: [AGES.youngest, AGES.oldest], factor: 1, unit: '' },
  tension: { usual: [0, 0.5], factor: 100, unit: '%' },
  angle: { usual: undefined, factor: 180 / Math.PI, unit: '°' },
  distance: { usual: undefined, factor: 1000, unit: 'mm' },
  number: { usual: undefined, factor: 1, unit: '' },
} as const satisfies Record<string, { usual: Range | undefined; factor: number; unit: string }>

/** The axis of a curve, wide enough for it. */
export function axisOf(kind: keyof typeof KINDS, label: string, curve: Readonly<Curve>): Axis {
  const { usual, factor, unit } = KINDS[kind]
  return { label, range: rangeAround(curve, usual), factor, unit }
}

/** A number of an axis as it is read: `45°`, `12.5 mm`, `0.3`. */
export function textOn({ factor, unit }: Axis, value: number): string {
  // Rounding leaves nothing of what is next to nothing.
  const number = Number((value * factor).toFixed(6)) && Number((value * factor).toPrecision(3))
  return unit === '' || unit === '°' || unit === '%' ? `${number}${unit}` : `${number} ${unit}`
}
