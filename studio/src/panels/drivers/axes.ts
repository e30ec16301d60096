import type { Curve } from 'furrow'
import { AGES } from 'furrow/internal'
import { type Range, rangeAround } from '../../document/curve.ts'

/** Input axis of a curve editor. */
export interface Axis {
  /** Label of the input: `browInnerUp`, `Age`. */
  readonly label: string
  readonly range: Range
  /** Factor from stored to displayed numbers. */
  readonly factor: number
  readonly unit: string
}

/** Default ranges and display units: radians as degrees, metres as millimetres. */
const KINDS = {
  fraction: { usual: [0, 1], factor: 1, unit: '' },
  age: { usual: [AGES.youngest, AGES.oldest], factor: 1, unit: '' },
  tension: { usual: [0, 0.5], factor: 100, unit: '%' },
  angle: { usual: undefined, factor: 180 / Math.PI, unit: '°' },
  distance: { usual: undefined, factor: 1000, unit: 'mm' },
  number: { usual: undefined, factor: 1, unit: '' },
} as const satisfies Record<string, { usual: Range | undefined; factor: number; unit: string }>

/** Makes an axis that contains the curve. */
export function axisOf(kind: keyof typeof KINDS, label: string, curve: Readonly<Curve>): Axis {
  const { usual, factor, unit } = KINDS[kind]
  return { label, range: rangeAround(curve, usual), factor, unit }
}

/** Formats a number with its unit: `45°`, `12.5 mm`, `0.3`. */
export function textOn({ factor, unit }: Axis, value: number): string {
  // Display tiny numbers as 0.
  const number = Number((value * factor).toFixed(6)) && Number((value * factor).toPrecision(3))
  return unit === '' || unit === '°' || unit === '%' ? `${number}${unit}` : `${number} ${unit}`
}
