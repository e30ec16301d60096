import { barycentrics2, interpolate } from '../../../math/barycentrics.ts'
import { atan2 } from '../../../math/elementary.ts'
import { cross, dot, length2, length3, normalize } from '../../../math/vector.ts'
import { crossed, subtract, type Vector, vectorAt } from '../../../math/vector3.ts'
import { cornersOf, type SkinSurface, type SurfacePoint } from '../../skin/surface.ts'
import type { LineStyle } from '../anatomy/region.ts'
import { keptRuns, type LaidLine } from '../lines/laid-line.ts'
import { STEP } from '../lines/trace.ts'
import { compressionAlong, tensorAt } from '../surface/tensors.ts'
import { softlyClamped } from './clamp.ts'

/** Coordinates on a part of a limb. */
export type LimbPoint = readonly [x: number, y: number]

/** Frame of a limb: a point on its axis, the unit direction of the axis, and a unit direction perpendicular to it. */
export interface LimbFrame {
  origin: Vector
  axis: Vector
  /** Direction of the angle 0. */
  front: Vector
}

/** Position around and along a limb: angle in radians from `front`, counterclockwise about the axis, distance along the axis, and radius. */
export function aroundLimb(
  { origin, axis, front }: LimbFrame,
  point: Vector,
): { angle: number; along: number; radius: number } {
  const offset = subtract(point, origin)
  const x = dot(offset, front)
  const y = dot(offset, crossed(axis, front))
  return { angle: atan2(y, x), along: dot(offset, axis), radius: length2(x, y) }
}

/** Part of a surface on which curves are drawn in two coordinates. Unlike `FlatChart`, it may distort lengths. */
export class LimbChart {
  readonly #surface: SkinSurface
  readonly #triangles: number[] = []
  /** For each triangle, x and y of its corners. */
  readonly #corners: number[] = []

  /**
   * @param place returns the coordinates of a point and its height above the limb's axis or plane; undefined outside the part.
   * @param period x is periodic with this period; triangles that cross the border are left out.
   */
  constructor(
    surface: SkinSurface,
    place: (point: number) => readonly [x: number, y: number] | undefined,
    isFacing: (normal: Vector, point: number) => boolean,
    period = Infinity,
  ) {
    this.#surface = surface
    const places = Array.from(surface.areas, (_, point) =>
      isFacing(vectorAt(surface.normals, point), point) ? place(point) : undefined,
    )
    for (let triangle = 0; triangle < surface.skinTriangles.length; triangle++) {
      const corners = cornersOf(surface, triangle).map((point) => places[point])
      if (!corners.every((corner) => corner !== undefined)) continue
      const xs = corners.map(([x]) => x)
      if (Math.max(...xs) - Math.min(...xs) > period / 2) continue
      this.#triangles.push(triangle)
      this.#corners.push(...corners.flat())
    }
  }

  /** Finds the point of the surface at the given coordinates. */
  lift([x, y]: LimbPoint): SurfacePoint | undefined {
    const weights = new Float64Array(3)
    const all = this.#corners
    for (let i = 0; i < this.#triangles.length; i++) {
      const k = 6 * i
      if (x < Math.min(all[k], all[k + 2], all[k + 4]) || x > Math.max(all[k], all[k + 2], all[k + 4]))
        continue
      if (
        y < Math.min(all[k + 1], all[k + 3], all[k + 5]) ||
        y > Math.max(all[k + 1], all[k + 3], all[k + 5])
      )
        continue
      barycentrics2(weights, all.slice(k, k + 6), x, y)
      if (!(weights[0] >= -1e-9 && weights[1] >= -1e-9 && weights[2] >= -1e-9)) continue
      const position = new Float64Array(3)
      const triangle = this.#triangles[i]
      const [a, b, c] = cornersOf(this.#surface, triangle)
      interpolate(position, this.#surface.points, 3, a, b, c, weights[0], weights[1], weights[2])
      return { triangle, position: [position[0], position[1], position[2]] }
    }
    return undefined
  }
}

/** Number of positions at which a curve is looked up. Lines get every position that is `STEP` from the previous one. */
const LOOKUPS = 480
/** Two neighbouring positions of a curve farther apart than this, in millimetres, do not belong to one line. */
const LEAP = 3

/** Curve on a limb and the style of its line. */
export interface LimbGuide {
  chart: LimbChart
  /** Returns the position at t, 0..1. */
  path(t: number): LimbPoint
  style: LineStyle
}

/** Returns a function that lays lines along curves, for `RegionPlan.lay`. */
export function guideLayer(
  surface: SkinSurface,
  guides: readonly LimbGuide[],
): (tensors: Float64Array) => LaidLine[] {
  return (tensors) => guides.flatMap((guide) => layGuide(surface, guide, tensors))
}

/** Lays a line along a curve. Parts outside the chart are cut off. */
function layGuide(
  surface: SkinSurface,
  { chart, path, style }: LimbGuide,
  tensors: Float64Array,
): LaidLine[] {
  const found = Array.from({ length: LOOKUPS + 1 }, (_, i) => chart.lift(path(i / LOOKUPS)))
  const isNear = (i: number) => i === 0 || gap(found[i - 1], found[i]) < LEAP
  return keptRuns(found.length, (i) => found[i] !== undefined && isNear(i)).flatMap(([start, end]) => {
    const points = evenlySpaced(found.slice(start, end) as SurfacePoint[])
    if (points.length < 3) return []
    return [
      {
        style,
        points: Float64Array.from(points.flatMap(({ position }) => [...position])),
        triangles: points.map(({ triangle }) => triangle),
        compressions: points.map((_, i) => compressionAcross(surface, tensors, points, i)),
      },
    ]
  })
}

function evenlySpaced(points: readonly SurfacePoint[]): SurfacePoint[] {
  const kept = [points[0]]
  for (const point of points) if (gap(kept[kept.length - 1], point) >= STEP) kept.push(point)
  return kept
}

function gap(a: SurfacePoint | undefined, b: SurfacePoint | undefined): number {
  if (!a || !b) return Infinity
  return length3(...(a.position.map((value, k) => value - b.position[k]) as [number, number, number]))
}

const [normal, side] = [new Float64Array(3), new Float64Array(3)]
const THIRDS = Float64Array.of(1 / 3, 1 / 3, 1 / 3)

/** Returns the compression of the skin across a line at one of its points. */
function compressionAcross(
  surface: SkinSurface,
  tensors: Float64Array,
  points: readonly SurfacePoint[],
  i: number,
): number {
  const before = points[Math.max(0, i - 1)].position
  const after = points[Math.min(points.length - 1, i + 1)].position
  const { triangle } = points[i]
  normal.fill(0)
  for (const point of cornersOf(surface, triangle))
    for (let k = 0; k < 3; k++) normal[k] += surface.normals[3 * point + k]
  cross(side, normal, [after[0] - before[0], after[1] - before[1], after[2] - before[2]])
  normalize(side)
  return softlyClamped(
    compressionAlong(tensorAt(surface, tensors, triangle, THIRDS), side[0], side[1], side[2]),
  )
}
