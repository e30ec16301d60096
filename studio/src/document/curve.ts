import type { Curve } from 'furrow'
import { curveAt } from 'furrow/internal'

/** Numbers from the least to the greatest. */
export type Range = readonly [low: number, high: number]

/** What a curve is drawn over, and how far its points go. */
export interface CurveRanges {
  readonly input: Range
  readonly output: Range
}

/** Parts of an axis by which arrow keys move a point, and which numbers are rounded to. */
const STEPS = 100

/** A neat number that is about a hundredth of a range: 0.01 of 0..1, 0.5 of 20..80. */
export function stepOf([low, high]: Range): number {
  const step = (high - low) / STEPS
  const power = 10 ** Math.floor(Math.log10(step))
  const digit = step / power
  // Only just below the next neat number is still that number.
  return power * (digit > 4.999 ? 5 : digit > 1.999 ? 2 : 1)
}

/** The curve with one of its points elsewhere: within the ranges, and between its neighbours. */
export function movePoint(
  curve: Readonly<Curve>,
  index: number,
  [input, output]: readonly [number, number],
  ranges: CurveRanges,
): Curve {
  const step = stepOf(ranges.input)
  const before = curve[index - 1]?.[0]
  const after = curve[index + 1]?.[0]
  const low = before === undefined ? ranges.input[0] : before + step
  const high = after === undefined ? ranges.input[1] : after - step
  const [old] = curve[index]
  const moved: Curve[number] = [
    low > high ? old : exact(clamp(rounded(input, step), [low, high])),
    clamp(rounded(output, stepOf(ranges.output)), ranges.output),
  ]
  return curve.map((point, i) => (i === index ? moved : point))
}

/** The curve with a point more on its line; as it is where the next one is nearer than a step. */
export function addPoint(curve: Readonly<Curve>, input: number, ranges: CurveRanges): Curve {
  const step = stepOf(ranges.input)
  const place = clamp(rounded(input, step), ranges.input)
  if (curve.some(([other]) => Math.abs(other - place) < step)) return [...curve]
  const output = rounded(curveAt(curve, place), stepOf(ranges.output))
  return [...curve, [place, output] as Curve[number]].sort(([a], [b]) => a - b)
}

/** The middle of the widest gap between points: where one more has most room. */
export function widestGap(curve: Readonly<Curve>): number {
  const gaps = curve
    .slice(1)
    .map(([input], i) => ({ width: input - curve[i][0], middle: (input + curve[i][0]) / 2 }))
  return gaps.reduce((widest, gap) => (gap.width > widest.width ? gap : widest)).middle
}

/** The curve without one of its points; as it is where only two are left. */
export function removePoint(curve: Readonly<Curve>, index: number): Curve {
  return curve.length > 2 ? curve.filter((_, i) => i !== index) : [...curve]
}

/** A range that holds the inputs of a curve, with room to drag its ends. */
export function rangeAround(curve: Readonly<Curve>, usual?: Range): Range {
  const [first, last] = [curve[0][0], curve[curve.length - 1][0]]
  if (usual && first >= usual[0] && last <= usual[1]) return usual
  const room = (last - first) / 4
  const [low, high] = [first - room, last + room]
  const step = 10 * stepOf([low, high])
  return [Math.floor(low / step) * step, Math.ceil(high / step) * step].map((end) => rounded(end, step)) as [
    number,
    number,
  ]
}

function clamp(value: number, [low, high]: Range): number {
  return Math.min(high, Math.max(low, value))
}

function rounded(value: number, step: number): number {
  return exact(Math.round(value / step) * step)
}

/** Without the digits that floating point adds. */
function exact(value: number): number {
  return Number(value.toPrecision(12))
}
