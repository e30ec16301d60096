import { exp } from '../../../math/elementary.ts'
import { KdTree } from '../../../math/kd-tree.ts'
import { clamp } from '../../../math/scalar.ts'
import { directionsInFrame, type FaceFrame, inFrame } from '../landmarks/face-frame.ts'
import type { MovingSurface } from '../landmarks/moving-surface.ts'
import { ALONG, closedEyes, type EyeOpening, eyeOpening, lipLine } from '../landmarks/openings.ts'
import { interpolated } from '../vectors.ts'
import { GRID, LID_REACH, LID_ROWS, LID_SAMPLES, LIP_ROWS, SAMPLES } from './sample-points.ts'

/** Displacements of all targets (blendshapes) at the points of `sample-points.ts`, which are at the same facial features on every face. */
export interface ShapeFields {
  /** Weight of each sample in comparisons; 0 for samples outside the skin. */
  weights: Float64Array
  shapes: ShapeField[]
}

export interface ShapeField {
  /** Index of the target. */
  target: number
  /** Displacement at each sample: u, v and depth in coordinates of `FaceFrame`. */
  field: Float64Array
  /** Largest displacement near the face, in face coordinates. It is the 99.9th percentile, to ignore outliers. */
  strength: number
  /** Whether the target closes the lids of the left and the right eye. */
  closes: readonly [left: boolean, right: boolean]
  /** Fraction of the motion outside the face, for example at the skull, the ears or the body. */
  outside: number
}

/** Points of the surface near a sample. The displacement at the sample is the weighted mean of their displacements. */
interface Blend {
  indices: number[]
  /** Weight of each point; the sum is 1. */
  weights: number[]
  /** Weight of the sample in `ShapeFields`. */
  weight: number
}

/** Lowest and highest v of a typical eye opening. Lid displacements are scaled as if the eye had this opening. */
const OPENING = [-0.14, 0.2] as const

/** Samples the displacements of all targets in face coordinates. */
export function shapeFields(surface: MovingSurface, frame: FaceFrame): ShapeFields {
  const [at, normals] = [inFrame(frame, surface.points), directionsOf(surface, frame)]
  const visible = visiblePoints(surface, frame, at, normals)
  const opening = eyeOpening(frame)
  const blends = [
    ...gridBlends(at, visible, opening),
    ...lidBlends(at, visible, opening),
    ...lipBlends(at, visible, frame),
  ]
  const [bottom, top] = heightsOf(opening)
  const gain = clamp((OPENING[1] - OPENING[0]) / Math.max(top - bottom, 0.05), 0.3, 2)
  const isLid = (sample: number) =>
    sample >= GRID.length && sample < GRID.length + LID_ROWS.length * LID_SAMPLES.length
  const closed = closedEyes(frame, surface.motions.length)
  const shapes = surface.motions.map(({ target, offsets }, motion): ShapeField => {
    const moved = directionsInFrame(frame, offsets)
    const field = new Float64Array(3 * SAMPLES)
    for (const [sample, { indices, weights }] of blends.entries()) {
      const scale = isLid(sample) ? gain : 1
      for (const [n, i] of indices.entries())
        for (let k = 0; k < 3; k++) field[3 * sample + k] += scale * weights[n] * moved[3 * i + k]
    }
    return { target, field, closes: closed[motion], ...extremes(moved, at, surface.areas, frame) }
  })
  return { weights: Float64Array.from(blends, ({ weight }) => weight), shapes }
}

function directionsOf({ normals }: MovingSurface, frame: FaceFrame): Float64Array {
  return directionsInFrame({ ...frame, scales: [1, 1, 1] }, normals)
}

/** Selects skin that faces forwards. Excludes connected components that are entirely near an eye, because they are eyeballs or lashes. */
function visiblePoints(
  { components }: MovingSurface,
  { region }: FaceFrame,
  at: Float64Array,
  normals: Float64Array,
): number[] {
  const isBeyondEye = new Set<number>()
  for (const i of region.near) {
    if (Math.abs(Math.abs(at[3 * i]) - 1) > 0.8 || Math.abs(at[3 * i + 1]) > 0.8)
      isBeyondEye.add(components[i])
  }
  return Array.from(region.near).filter((i) => {
    const [u, v] = [at[3 * i], at[3 * i + 1]]
    return (
      normals[3 * i + 2] > 0.05 && Math.abs(u) < 3 && v > -4.2 && v < 2.9 && isBeyondEye.has(components[i])
    )
  })
}

function heightsOf({ upper, lower }: EyeOpening): [bottom: number, top: number] {
  return [Math.min(...lower), Math.max(...upper)]
}

/**
 * Returns the blends of the grid points. The face is warped so that its eyes are centred at u = -1 and u = 1, and their openings reach from
 * `OPENING[0]` to `OPENING[1]`.
 */
function gridBlends(at: Float64Array, visible: readonly number[], opening: EyeOpening): Blend[] {
  const [bottom, top] = heightsOf(opening)
  const from = [-5, -2, bottom, top, top + 4]
  const to = [-5, -2, ...OPENING, 4.2]
  const warped = visible.flatMap((i) => [
    at[3 * i] / opening.middle,
    interpolated(at[3 * i + 1], from, to),
    at[3 * i + 2],
  ])
  const queries = GRID.flatMap(({ u, v }) => [u, v])
  return blendsOf(warped, visible, queries, 0.1, 1)
}

/** Returns the blends along the lids. Upper lids use only skin above the middle of the eye, lower lids only skin below the middle. */
function lidBlends(at: Float64Array, visible: readonly number[], opening: EyeOpening): Blend[] {
  const along = ALONG.map((a) => LID_REACH * a)
  const middles = opening.upper.map((height, k) => (height + opening.lower[k]) / 2)
  return LID_ROWS.flatMap(({ side, lid, distance }) => {
    const chosen = visible.filter((i) => {
      const x = (side * at[3 * i] - opening.middle) / opening.halfWidth
      const height = at[3 * i + 1] - interpolated(x, along, middles)
      return Math.abs(x) < 1.6 && lid * height > 0 && Math.abs(height) < 1.2
    })
    const edge = lid > 0 ? opening.upper : opening.lower
    const queries = LID_SAMPLES.flatMap((k) => [
      side * (opening.middle + opening.halfWidth * along[k]),
      edge[k] + lid * distance,
    ])
    return blendsOf(coordinates(at, chosen), chosen, queries, 0.06, 0.6)
  })
}

/** Returns the blends along the lips. The upper lip uses only skin above the lip line, the lower lip only skin below this line. */
function lipBlends(at: Float64Array, visible: readonly number[], frame: FaceFrame): Blend[] {
  const { halfWidth, heights } = lipLine(frame)
  const us = ALONG.map((a) => halfWidth * a)
  return LIP_ROWS.flatMap(({ lip, distance }) => {
    const chosen = visible.filter((i) => {
      const height = at[3 * i + 1] - interpolated(at[3 * i], us, heights)
      return Math.abs(at[3 * i]) < 1.3 && lip * height > 0 && Math.abs(height) < 0.6
    })
    const queries = us.flatMap((u, k) => [u, heights[k] + lip * distance])
    return blendsOf(coordinates(at, chosen), chosen, queries, 0.08, 0.8)
  })
}

function coordinates(at: Float64Array, chosen: readonly number[]): number[] {
  return chosen.flatMap((i) => [at[3 * i], at[3 * i + 1], at[3 * i + 2]])
}

/** Maximum number of points blended per sample. */
const NEIGHBOURS = 10
/** Maximum distance, in face coordinates, from a sample to the nearest point. Samples farther away have no weight. */
const MAX_REACH = 0.35

/**
 * Returns a blend of the nearest points for each queried position (Nadaraya-Watson kernel regression). If points are behind each other, the
 * foremost ones have the most weight.
 *
 * @param at position of each point: u, v and depth.
 * @param points index of each point in the surface.
 * @param queries u and v of each position.
 * @param sigma minimum width of the kernel.
 * @param weight weight of samples that have a point nearby.
 */
function blendsOf(
  at: readonly number[],
  points: readonly number[],
  queries: readonly number[],
  sigma: number,
  weight: number,
): Blend[] {
  const count = queries.length / 2
  if (points.length < 6) return Array.from({ length: count }, () => ({ indices: [], weights: [], weight: 0 }))
  const plane = points.flatMap((_, i) => [at[3 * i], at[3 * i + 1]])
  const tree = new KdTree(plane, 2, NEIGHBOURS)
  return Array.from({ length: count }, (_, q): Blend => {
    const found = tree.nearest(queries, 2 * q)
    const indices = Array.from(found.indices.subarray(0, found.count))
    const distances = Array.from(found.squares.subarray(0, found.count), Math.sqrt)
    const width = Math.max(sigma, 0.7 * distances[2])
    const depths = indices.map((i) => at[3 * i + 2])
    const front = depths.reduce((most, z, n) => (distances[n] < 2 * width ? Math.max(most, z) : most), -9)
    const weights = indices.map(
      (_, n) => exp(-0.5 * (distances[n] / width) ** 2) * exp(-Math.max(0, front - depths[n]) / 0.15) + 1e-9,
    )
    const total = weights.reduce((a, b) => a + b, 0)
    return {
      indices: indices.map((i) => points[i]),
      weights: weights.map((w) => w / total),
      weight: distances[0] < MAX_REACH ? weight : 0,
    }
  })
}

/** Measures the largest displacement near the face, and the fraction of the motion outside the face. */
function extremes(
  moved: Float64Array,
  at: Float64Array,
  areas: Float64Array,
  { region }: FaceFrame,
): Pick<ShapeField, 'strength' | 'outside'> {
  const length = (i: number) => Math.sqrt(moved[3 * i] ** 2 + moved[3 * i + 1] ** 2 + moved[3 * i + 2] ** 2)
  const lengths = Float64Array.from({ length: Math.ceil(region.near.length / 4) }, (_, n) =>
    length(region.near[4 * n]),
  ).sort()
  let [beyond, total] = [0, 0]
  for (let i = 0; i < areas.length; i++) {
    const motion = areas[i] * length(i)
    total += motion
    const [u, v, depth] = [at[3 * i], at[3 * i + 1], at[3 * i + 2]]
    if (Math.abs(u) > 2.6 || v > 2.6 || v < -4.5 || depth < -2) beyond += motion
  }
  return {
    strength: lengths[Math.floor(0.999 * (lengths.length - 1))],
    outside: total > 0 ? beyond / total : 1,
  }
}
