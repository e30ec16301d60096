import type { SurfacePlace } from './chart.ts'
import { crossOf, type Surface } from './surface.ts'

/** Millimetres between points of a line. */
export const STEP = 0.6

/** Share of the way to a triangle's middle that a line is pulled as it enters. */
const INWARDS = 1e-3

/** A line on a surface. */
export interface Trace {
  /** x, y and z of each point. */
  points: number[]
  /** The surface's normals there. */
  normals: number[]
}

/**
 * The direction in which a line goes on.
 *
 * @param point where it is.
 * @param normal of the surface there.
 * @param triangle and the shares of its corners, to look up what is known at points.
 * @param out takes x, y and z.
 * @returns whether it goes on at all.
 */
export type Direction = (
  point: Float64Array,
  normal: Float64Array,
  triangle: number,
  shares: Float64Array,
  out: Float64Array,
) => boolean

/**
 * Draws a line over a surface from triangle to triangle, until the direction says stop or the surface ends.
 *
 * @param longest length at most, in millimetres.
 */
export function traceLine(
  surface: Surface,
  start: SurfacePlace,
  direction: Direction,
  longest: number,
): Trace {
  const at = Float64Array.from(start.point)
  const [normal, way, shares] = [new Float64Array(3), new Float64Array(3), new Float64Array(3)]
  const trace: Trace = { points: [], normals: [] }
  let triangle = start.triangle
  for (let gone = 0; gone <= longest; gone += STEP) {
    sharesAt(surface, triangle, at, shares)
    normalAt(surface, triangle, shares, normal)
    trace.points.push(...at)
    trace.normals.push(...normal)
    if (!direction(at, normal, triangle, shares, way)) break
    triangle = walk(surface, triangle, at, way, STEP)
    if (triangle < 0) break
  }
  return trace
}

/** Goes on over as many triangles as a step crosses; returns the last one, or -1 at the surface's end. */
function walk(surface: Surface, from: number, at: Float64Array, way: Float64Array, step: number): number {
  let triangle = from
  let left = step
  const now = new Float64Array(3)
  const then = new Float64Array(3)
  const ahead = new Float64Array(3)
  // A step of half a millimetre seldom crosses more than two.
  for (let crossed = 0; crossed < 8; crossed++) {
    flatten(surface, triangle, way, ahead)
    sharesAt(surface, triangle, at, now)
    for (let k = 0; k < 3; k++) ahead[k] = at[k]! + left * ahead[k]!
    sharesAt(surface, triangle, ahead, then)
    let [share, edge] = [1, -1]
    for (let k = 0; k < 3; k++) {
      if (then[k]! >= 0) continue
      const out = Math.max(now[k]!, 0) / (Math.max(now[k]!, 0) - then[k]!)
      if (out < share || edge < 0) [share, edge] = [out, (k + 1) % 3]
    }
    for (let k = 0; k < 3; k++) at[k]! += share * (ahead[k]! - at[k]!)
    if (edge < 0) return triangle
    left *= 1 - share
    const next = surface.beyond[3 * triangle + edge]!
    if (next < 0) return -1
    triangle = next
    pullIn(surface, triangle, at)
    if (left < 1e-6) return triangle
  }
  return triangle
}

/** Keeps a line that runs along an edge or through a corner from going to and fro between two triangles. */
function pullIn({ points, corners }: Surface, triangle: number, at: Float64Array): void {
  for (let k = 0; k < 3; k++) {
    let middle = 0
    for (let j = 0; j < 3; j++) middle += points[3 * corners[3 * triangle + j]! + k]! / 3
    at[k]! += INWARDS * (middle - at[k]!)
  }
}

/** Turns a direction into a triangle's plane, of length 1. */
function flatten({ points, corners }: Surface, triangle: number, way: Float64Array, out: Float64Array): void {
  const first = 3 * triangle
  crossOf(points, corners[first]!, corners[first + 1]!, corners[first + 2]!, out)
  const [nx, ny, nz] = [out[0]!, out[1]!, out[2]!]
  const rise = (nx * way[0]! + ny * way[1]! + nz * way[2]!) / (nx * nx + ny * ny + nz * nz)
  out[0] = way[0]! - rise * nx
  out[1] = way[1]! - rise * ny
  out[2] = way[2]! - rise * nz
  const length = Math.hypot(out[0]!, out[1]!, out[2]!) || 1
  for (let k = 0; k < 3; k++) out[k]! /= length
}

/** Shares of the corners at a point of a triangle's plane (Ericson, Real-Time Collision Detection, 3.4). */
function sharesAt({ points, corners }: Surface, triangle: number, at: Float64Array, out: Float64Array): void {
  const [a, b, c] = [0, 1, 2].map((k) => 3 * corners[3 * triangle + k]!) as [number, number, number]
  let [uu, uv, vv, pu, pv] = [0, 0, 0, 0, 0]
  for (let k = 0; k < 3; k++) {
    const u = points[b + k]! - points[a + k]!
    const v = points[c + k]! - points[a + k]!
    const p = at[k]! - points[a + k]!
    uu += u * u
    uv += u * v
    vv += v * v
    pu += p * u
    pv += p * v
  }
  const det = uu * vv - uv * uv
  out[1] = (vv * pu - uv * pv) / det
  out[2] = (uu * pv - uv * pu) / det
  out[0] = 1 - out[1]! - out[2]!
}

function normalAt(
  { normals, corners }: Surface,
  triangle: number,
  shares: Float64Array,
  out: Float64Array,
): void {
  out.fill(0)
  for (let j = 0; j < 3; j++) {
    for (let k = 0; k < 3; k++) out[k]! += shares[j]! * normals[3 * corners[3 * triangle + j]! + k]!
  }
  const length = Math.hypot(out[0]!, out[1]!, out[2]!) || 1
  for (let k = 0; k < 3; k++) out[k]! /= length
}
