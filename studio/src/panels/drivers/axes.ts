import type { Curve } from 'furrow'
import { AGES } from 'furrow/internal'
import { type Range, rangeAround } from '../../document/curve.ts'

/** Input axis of a curve editor. */
export interface Axis {
  /** Label of the input, such as `browInnerUp` or `Age`. */
  readonly label: string
  readonly range: Range
  /** Factor by which stored numbers are multiplied for display. */
  readonly factor: number
  readonly unit: string
}

/** Usual ranges, and units for display. Radians are displayed in degrees, and metres in millimetres. */
const KINDS = {
  fraction: { usual: [0, 1], factor: 1, unit: '' },
  age: { usual: [AGES.youngest, AGES.oldest], factor: 1, unit: '' },
  tension: { usual: [0, 0.5], factor: 100, unit: '%' },
  angle: { usual: undefined, factor: 180 / Math.PI, unit: '°' },
  distance: { usual: undefined, factor: 1000, unit: 'mm' },
  number: { usual: undefined, factor: 1, unit: '' },
} as const satisfies Record<string, { usual: Range | undefined; factor: number; unit: string }>

/** Makes an axis whose range contains all points of a curve. */
export function axisOf(kind: keyof typeof KINDS, label: string, curve: Readonly<Curve>): Axis {
  const { usual, factor, unit } = KINDS[kind]
  return { label, range: rangeAround(curve, usual), factor, unit }
}

/** Formats a number with its unit: `45°`, `12.5 mm`, `0.3`. */
export function textOn({ factor, unit }: Axis, value: number): string {
  // Numbers that `toFixed` rounds to 0 are displayed as 0.
  const number = Number((value * factor).toFixed(6)) && Number((value * factor).toPrecision(3))
  return unit === '' || unit === '°' || unit === '%' ? `${number}${unit}` : `${number} ${unit}`
}
