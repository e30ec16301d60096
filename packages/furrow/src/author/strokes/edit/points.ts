import { FurrowError } from '../../../core/error.ts'
import type { LocatedSkin } from '../curve.ts'
import type { Stroke } from '../document.ts'
import { splineOf } from './spline-of.ts'
import { knotsOf, traceStroke, uvOf } from './traced-stroke.ts'

/**
 * Inserts a control point on the line of a stroke (a wrinkle). The insertion moves the line by at most 0.1 mm.
 *
 * @param along position on the line as a fraction of its length, 0..1.
 * @returns the stroke, converted to a spline by `splineOf`, and the index of the new point. Returns the unchanged stroke and -1 if the stroke
 *   already has a point at this position, or is outside the skin.
 */
export function insertPoint<S extends Stroke>(
  stroke: S,
  along: number,
  skin: LocatedSkin,
): { stroke: S; index: number } {
  const spline = splineOf(stroke, skin)
  const line = traceStroke(spline, skin)
  const length = along * (line.lengths.at(-1) ?? 0)
  const place = line.lengths.findIndex((each) => each >= length)
  const knots = knotsOf(spline, line, skin)
  if (place < 0 || knots.includes(place)) return { stroke, index: -1 }
  const index = knots.filter((knot) => knot < place).length
  return { stroke: { ...spline, points: spline.points.toSpliced(index, 0, uvOf(line, place, skin)) }, index }
}

/**
 * Removes a point of a stroke.
 *
 * @param index index of the point in the spline that `splineOf` returns for the stroke.
 * @throws FurrowError if the index is out of range, or the stroke has only two points.
 */
export function removePoint<S extends Stroke>(stroke: S, index: number, skin: LocatedSkin): S {
  const spline = splineOf(stroke, skin)
  checkIndex('removePoint', index, 0, spline.points.length - 1)
  if (spline.points.length <= 2) {
    throw new FurrowError({
      who: 'removePoint',
      problem: 'a stroke needs two points',
      value: spline.points.length,
      limit: '3 points or more',
      remedy: 'remove the stroke',
    })
  }
  return { ...spline, points: spline.points.toSpliced(index, 1) }
}

export function checkIndex(who: string, index: number, lowest: number, highest: number): void {
  if (Number.isInteger(index) && index >= lowest && index <= highest) return
  throw new FurrowError({
    code: 'out-of-range',
    who,
    problem: 'point index out of range',
    value: index,
    limit: lowest <= highest ? `${lowest}..${highest}` : 'a stroke of 3 points or more',
    remedy: 'use the index of an existing point',
  })
}
