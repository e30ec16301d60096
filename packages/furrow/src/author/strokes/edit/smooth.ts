import { length3 } from '../../../math/vector.ts'
import type { LocatedSkin } from '../curve.ts'
import type { Stroke } from '../document.ts'
import { moveOver, placeAt } from './over-skin.ts'
import { splineOf } from './spline-of.ts'

/** Weight of the third differences against the distances from the points. A higher weight also smooths longer waves. */
const STIFFNESS = 8
/** Number of points in a third difference. */
const SPAN = 4

/**
 * Smooths a stroke: removes jitter of its points, and keeps bends. Ends stay, and so do strokes of fewer than four points, in which a bend and
 * jitter look the same. The method minimises the third differences of the points, so that an arc stays an arc (Whittaker 1922).
 *
 * @param amount strength, 0..1: 0 leaves the points in place.
 * @returns the stroke, converted to a spline by `splineOf`.
 */
export function smoothStroke<S extends Stroke>(stroke: S, amount: number, skin: LocatedSkin): S {
  const spline = splineOf(stroke, skin)
  const places = spline.points.map((uv) => placeAt(uv, skin))
  const known = places.filter((place) => place !== null)
  if (known.length < SPAN) return spline
  const smooth = smoothed(known.map(({ position }) => position))
  let next = 0
  const points = spline.points.map((uv, i) => {
    const place = places[i]
    if (!place) return uv
    const target = smooth[next++]
    if (next === 1 || next === known.length) return uv
    const step = target.map((value, k) => amount * (value - place.position[k]))
    return moveOver(place, step, skin)
  })
  return { ...spline, points }
}

/** Returns the points that minimise the squared distances from `points` plus `STIFFNESS` times the squared third differences. The ends stay. */
function smoothed(points: readonly Float64Array[]): Float64Array[] {
  const count = points.length
  const matrix = Array.from({ length: count }, (_, i) => {
    const row = new Float64Array(count)
    row[i] = 1
    return row
  })
  const along = [0]
  for (let i = 1; i < count; i++) along.push(along[i - 1] + (distance(points[i - 1], points[i]) || 1e-6))
  for (let first = 0; first + SPAN <= count; first++) {
    const row = thirdDifference(along.slice(first, first + SPAN))
    for (let i = 0; i < SPAN; i++)
      for (let k = 0; k < SPAN; k++) matrix[first + i][first + k] += STIFFNESS * row[i] * row[k]
  }
  for (const end of [0, count - 1])
    matrix[end] = Float64Array.from(matrix[end], (_, k) => (k === end ? 1 : 0))
  return solve(matrix, points)
}

/** Returns the factors of four points in their third difference, with the norm of the factors 1, -3, 3, -1. @param along arc lengths of the points. */
function thirdDifference(along: readonly number[]): number[] {
  const factors = along.map((own, i) =>
    along.reduce((product, other, k) => (k === i ? product : product / (own - other)), 1),
  )
  const norm = Math.sqrt(20 / factors.reduce((sum, factor) => sum + factor * factor, 0))
  return factors.map((factor) => factor * norm)
}

/** Solves a system of linear equations by Gaussian elimination. The matrix has nonzero elements only near its diagonal. */
function solve(matrix: readonly Float64Array[], values: readonly Float64Array[]): Float64Array[] {
  const rows = matrix.map((row) => row.slice())
  const out = values.map((value) => value.slice())
  const count = rows.length
  for (let i = 0; i < count; i++) {
    for (let below = i + 1; below < Math.min(i + SPAN, count); below++) {
      const factor = rows[below][i] / rows[i][i]
      for (let k = i; k < Math.min(i + SPAN, count); k++) rows[below][k] -= factor * rows[i][k]
      for (let k = 0; k < 3; k++) out[below][k] -= factor * out[i][k]
    }
  }
  for (let i = count - 1; i >= 0; i--) {
    for (let right = i + 1; right < Math.min(i + SPAN, count); right++)
      for (let k = 0; k < 3; k++) out[i][k] -= rows[i][right] * out[right][k]
    for (let k = 0; k < 3; k++) out[i][k] /= rows[i][i]
  }
  return out
}

function distance(a: Float64Array, b: Float64Array): number {
  return length3(a[0] - b[0], a[1] - b[1], a[2] - b[2])
}
