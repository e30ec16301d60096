import type { Curve } from 'furrow'
import { curveAt } from 'furrow/internal'

export type Range = readonly [low: number, high: number]

/** Ranges of both axes of a curve. A curve maps an input of a driver to the activation of an area. */
export interface CurveRanges {
  readonly input: Range
  readonly output: Range
}

/** Approximate number of steps along an axis. */
const STEPS = 100

/** Returns the step by which points move, a round number: 0.01 for the range 0..1, 0.5 for 20..80. */
export function stepOf([low, high]: Range): number {
  const step = (high - low) / STEPS
  const power = 10 ** Math.floor(Math.log10(step))
  const digit = step / power
  // Rounding errors can turn the digit 2 or 5 into 1.9999 or 4.9999.
  return power * (digit > 4.999 ? 5 : digit > 1.999 ? 2 : 1)
}

/** Moves one point of a curve. Keeps it within the ranges and between its neighbours. */
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

/** Adds a point on the curve, unless the curve has a point less than one step away. */
export function addPoint(curve: Readonly<Curve>, input: number, ranges: CurveRanges): Curve {
  const step = stepOf(ranges.input)
  const place = clamp(rounded(input, step), ranges.input)
  if (curve.some(([other]) => Math.abs(other - place) < step)) return [...curve]
  const output = rounded(curveAt(curve, place), stepOf(ranges.output))
  return [...curve, [place, output] as Curve[number]].sort(([a], [b]) => a - b)
}

/** Returns the input in the middle of the widest gap between neighbouring points. */
export function widestGap(curve: Readonly<Curve>): number {
  const gaps = curve
    .slice(1)
    .map(([input], i) => ({ width: input - curve[i][0], middle: (input + curve[i][0]) / 2 }))
  return gaps.reduce((widest, gap) => (gap.width > widest.width ? gap : widest)).middle
}

export function removePoint(curve: Readonly<Curve>, index: number): Curve {
  return curve.length > 2 ? curve.filter((_, i) => i !== index) : [...curve]
}

/** Returns `usual` if it contains the inputs of all points. Otherwise returns a wider, rounded range, so that users can drag the end points. */
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

/** Rounds to 12 digits, which removes floating-point errors. */
function exact(value: number): number {
  return Number(value.toPrecision(12))
}
