import { quantile } from '../../../math/quantile.ts'
import { across, crossed, dotOf, lengthOf, minus, plus, unit, type Vector, vectorAt } from '../vectors.ts'
import { type ClosingPair, closingPairs, eyesOf } from './closing-lids.ts'
import { type LipSeam, lipSeam } from './lip-seam.ts'
import { type MirrorFit, mirrorPlane } from './mirror-plane.ts'
import { type MovingRegion, movingRegion } from './moving-region.ts'
import type { MovingSurface } from './moving-surface.ts'

/**
 * Face coordinates (u, v, depth), which do not depend on a face's size or proportions. The eyes are at u = -1 and u = 1 with v = 0. The
 * mouth is at u = 0 with v = -2. Positive u is the person's left, positive v is up, and positive depth is forwards.
 */
export interface FaceFrame {
  region: MovingRegion
  /** Midpoint of the eyes. */
  origin: Vector
  /** Unit axes: left, up and forwards. */
  axes: readonly [Vector, Vector, Vector]
  /** Length of one mesh unit in face coordinates, along each axis. */
  scales: Vector
  eyes: readonly [left: Vector, right: Vector]
  /** Whether the eyes were found from closing lids. If not, they are placed relative to the mouth. */
  hasLids: boolean
  mouth: Vector
  seam: LipSeam | undefined
  closing: readonly ClosingPair[]
}

// Typical proportions, in units of half the distance between the eyes. They place the eyes if no lids close, or the mouth if no lips part.
/** Half the width of the mouth. */
const MOUTH_WIDTH = 0.73
/** Height of the eyes above the mouth. */
const EYE_HEIGHT = 2.1
/** Minimum height of the eyes above the mouth. */
const MIN_EYE_HEIGHT = 0.3

/**
 * Finds the face coordinates of a surface from the motion of its targets (blendshapes). Neither names nor an up axis are needed.
 *
 * @returns undefined if the moving region has under 50 points, or if no target closes lids and the lips move alike or do not part.
 */
export function faceFrame(surface: MovingSurface): FaceFrame | undefined {
  const region = movingRegion(surface)
  if (!region || region.near.length < 50) return undefined
  const plane = mirrorPlane(surface, region)
  const forward = unit(across(facing(surface, region), plane.normal))
  const seam = lipSeam(surface, region, plane, forward)
  const closing = closingPairs(surface, region, plane)
  const up = seam && upFromLips(surface, region, plane, forward, seam.centre)
  const isAbove = (eye: Vector) => {
    if (!seam) return true
    const from = across(minus(eye, seam.centre), plane.normal)
    const rise = across(from, forward)
    return Math.abs(dotOf(from, forward)) < lengthOf(rise) && !(up && dotOf(rise, up) < 0)
  }
  const lids = eyesOf(closing, region, plane, seam?.centre, isAbove)
  const eyes = lids ?? (seam && up && eyesAbove(region, plane, forward, seam, up))
  if (!eyes) return undefined
  const onPlane = (point: Vector) =>
    plus(point, plane.normal, -dotOf(minus(point, plane.origin), plane.normal))
  const half = Math.abs(dotOf(minus(eyes[0], eyes[1]), plane.normal)) / 2
  const origin = onPlane(eyes[0])
  const mouth = onPlane(seam?.centre ?? belowEyes(region, origin, crossed(forward, plane.normal), half))
  const y = unit(across(minus(origin, mouth), plane.normal))
  const z = unit(across(forward, y))
  const x = crossed(y, z)
  const height = Math.max(dotOf(minus(origin, mouth), y), MIN_EYE_HEIGHT * half)
  const isFirstLeft = dotOf(minus(eyes[0], eyes[1]), x) > 0
  return {
    region,
    origin,
    axes: [x, y, z],
    scales: [1 / half, 2 / height, 2 / (half + height / 2)],
    hasLids: lids !== undefined,
    eyes: isFirstLeft ? eyes : [eyes[1], eyes[0]],
    mouth,
    seam,
    closing,
  }
}

/** Returns the sum of the normals of moving skin, weighted by motion. Normals that point to the moving region's centre are ignored. */
function facing({ points, normals }: MovingSurface, { centre, heat, near }: MovingRegion): Vector {
  return near.reduce<Vector>(
    (sum, i) => {
      const normal = vectorAt(normals, i)
      const outwards = dotOf(unit(minus(vectorAt(points, i), centre)), normal)
      return plus(sum, normal, heat[i] * Math.max(0, outwards))
    },
    [0, 0, 0],
  )
}

/** Places the mouth at a typical distance from the eyes, in the direction of the moving region's centre. */
function belowEyes({ centre }: MovingRegion, eyes: Vector, up: Vector, half: number): Vector {
  const sign = dotOf(minus(eyes, centre), up) < 0 ? -1 : 1
  return plus(eyes, up, -sign * EYE_HEIGHT * half)
}

/** Minimum ratio of the lower lip's motion to the upper lip's motion. At smaller ratios, the direction up is unknown. */
const LOWER_LIP = 1.1

/** Finds the direction from the lower lip, which targets move more, to the upper lip. Returns undefined if targets move both lips alike. */
function upFromLips(
  { points, areas, motions }: MovingSurface,
  { radius, near }: MovingRegion,
  { normal }: MirrorFit,
  forward: Vector,
  mouth: Vector,
): Vector | undefined {
  const up = crossed(forward, normal)
  const moved = [0, 0]
  for (const i of near) {
    const from = minus(vectorAt(points, i), mouth)
    const rise = dotOf(from, up) / radius
    const isLip =
      Math.abs(dotOf(from, normal)) < 0.4 * radius &&
      dotOf(from, forward) > -0.3 * radius &&
      Math.abs(rise) < 0.6
    if (!isLip || Math.abs(rise) < 0.05) continue
    for (const { distances } of motions) moved[rise > 0 ? 1 : 0] += areas[i] * distances[i]
  }
  const [below, above] = moved
  if (below > LOWER_LIP * above) return up
  return above > LOWER_LIP * below ? plus([0, 0, 0], up, -1) : undefined
}

/** Places eyes above the mouth at a distance derived from the mouth's width. */
function eyesAbove(
  { radius }: MovingRegion,
  { origin, normal }: MirrorFit,
  forward: Vector,
  { centre, points }: LipSeam,
  up: Vector,
): [Vector, Vector] {
  const offset = (point: Vector) => dotOf(minus(point, origin), normal)
  const lips = points.filter((point) => dotOf(minus(point, centre), forward) > -0.25 * radius)
  const width = quantile(
    lips.map((point) => Math.abs(offset(point))),
    0.98,
  )
  const half = width / MOUTH_WIDTH
  const middle = plus(plus(centre, normal, -offset(centre)), up, EYE_HEIGHT * half)
  return [plus(middle, normal, half), plus(middle, normal, -half)]
}

/** Transforms points into face coordinates. */
export function inFrame({ origin, axes, scales }: FaceFrame, points: Float64Array): Float64Array {
  return transformed(points, origin, axes, scales)
}

/** Transforms displacements into face coordinates. */
export function directionsInFrame({ axes, scales }: FaceFrame, offsets: Float64Array): Float64Array {
  return transformed(offsets, [0, 0, 0], axes, scales)
}

/** Transforms a position into face coordinates. */
export function positionInFrame({ origin, axes, scales }: FaceFrame, point: Vector): Vector {
  const from = minus(point, origin)
  return [
    dotOf(from, axes[0]) * scales[0],
    dotOf(from, axes[1]) * scales[1],
    dotOf(from, axes[2]) * scales[2],
  ]
}

function transformed(
  values: Float64Array,
  from: Vector,
  axes: FaceFrame['axes'],
  scales: Vector,
): Float64Array {
  const out = new Float64Array(values.length)
  for (const [row, axis] of axes.entries()) {
    const [ax, ay, az] = axis.map((a) => a * scales[row])
    for (let i = 0; i < values.length; i += 3)
      out[i + row] =
        ax * (values[i] - from[0]) + ay * (values[i + 1] - from[1]) + az * (values[i + 2] - from[2])
  }
  return out
}
