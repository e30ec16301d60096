import type { Curve } from 'furrow'
import { curveAt } from 'furrow/internal'

/** Numeric range. */
export type Range = readonly [low: number, high: number]

/** Axis ranges of a curve editor. */
export interface CurveRanges {
  readonly input: Range
  readonly output: Range
}

/** Steps per axis, for arrow keys and rounding. */
const STEPS = 100

/** Returns a round number near a hundredth of a range: 0.01 for 0..1, 0.5 for 20..80. */
export function stepOf([low, high]: Range): number {
  const step = (high - low) / STEPS
  const power = 10 ** Math.floor(Math.log10(step))
  const digit = step / power
  // Tolerates rounding just below the next round number.
  return power * (digit > 4.999 ? 5 : digit > 1.999 ? 2 : 1)
}

/** Moves one point of a curve, clamped to the ranges and between its neighbours. */
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

/** Adds a point on the curve, unless another point is within one step. */
export function addPoint(curve: Readonly<Curve>, input: number, ranges: CurveRanges): Curve {
  const step = stepOf(ranges.input)
  const place = clamp(rounded(input, step), ranges.input)
  if (curve.some(([other]) => Math.abs(other - place) < step)) return [...curve]
  const output = rounded(curveAt(curve, place), stepOf(ranges.output))
  return [...curve, [place, output] as Curve[number]].sort(([a], [b]) => a - b)
}

/** Returns the middle of the widest gap between points. */
export function widestGap(curve: Readonly<Curve>): number {
  const gaps = curve
    .slice(1)
    .map(([input], i) => ({ width: input - curve[i][0], middle: (input + curve[i][0]) / 2 }))
  return gaps.reduce((widest, gap) => (gap.width > widest.width ? gap : widest)).middle
}

/** Removes a point, unless only two are left. */
export function removePoint(curve: Readonly<Curve>, index: number): Curve {
  return curve.length > 2 ? curve.filter((_, i) => i !== index) : [...curve]
}

/** Returns `usual` if it holds all inputs of a curve, else a rounded range with room to drag the ends. */
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

/** Removes floating-point noise. */
function exact(value: number): number {
  return Number(value.toPrecision(12))
}
