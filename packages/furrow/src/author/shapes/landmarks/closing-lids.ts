import { quantile } from '../../../math/quantile.ts'
import { dotOf, lengthOf, minus, plus, type Vector, vectorAt } from '../vectors.ts'
import type { MirrorFit } from './mirror-plane.ts'
import type { MovingRegion } from './moving-region.ts'
import { distanceBetween, type MovingSurface, pickPoints, treeOf } from './moving-surface.ts'

/** Two points of skin that a target (blendshape) brings together. Positions and distances are those of the rest pose. */
export interface ClosingPair {
  first: Vector
  second: Vector
  middle: Vector
  /** Distance between the points. */
  gap: number
  /** Index of the target's motion in `MovingSurface.motions`. */
  motion: number
}

// Distances are in units of `MovingRegion.radius`.
/** Maximum distance between two points that a target has brought together. */
const TOGETHER = 0.04
/** Minimum distance at rest between two points that a target brings together. */
const MIN_GAP = 0.1
/** A target is ignored if its largest displacement is smaller than this. */
const WEAK = 0.03
/** Minimum distance of eyes from the symmetry plane. */
const MIN_PLANE_DISTANCE = 0.2
/** Minimum distance of eyes from the mouth. */
const FROM_MOUTH = 0.65
/** Two targets close the same eye if the mean positions of their pairs are at most this far apart. */
const ONE_EYE = 0.3
/** Minimum ratio of the distance between two points at rest to their distance when the target has brought them together. */
const RATIO = 4
/** A target moves a point if the point's displacement exceeds this fraction of the target's largest displacement. */
const MOVED = 0.25
/** Maximum fraction of the points that a target moves when it closes lids. */
const MAX_MOVED = 0.5
/**
 * A target is ignored if it shrinks the points that it moves on either side of the face below this fraction of their extent. Such a target
 * hides a part of the mesh, such as a second set of eyes.
 */
const SHRUNK = 0.5
const NEIGHBOURS = 8
/** Minimum number of pairs per target, counting both eyes. */
const MIN_PAIRS = 8

/** Finds pairs of skin points that a target brings together. */
export function closingPairs(
  { points, components, motions }: MovingSurface,
  { radius, near }: MovingRegion,
  { origin, normal: x }: MirrorFit,
): ClosingPair[] {
  const pairs: ClosingPair[] = []
  const side = near.map((i) => (dotOf(minus(vectorAt(points, i), origin), x) > 0 ? 1 : 0))
  const moved = new Float64Array(points.length)
  for (const [motion, { offsets, distances, largest }] of motions.entries()) {
    if (largest < WEAK * radius) continue
    const movers = near.filter((i) => distances[i] > MOVED * largest)
    if (movers.length < 6 || movers.length > MAX_MOVED * near.length) continue
    for (let i = 0; i < moved.length; i++) moved[i] = points[i] + offsets[i]
    const halves = [0, 1].map((half) =>
      near.filter((i, k) => side[k] === half && distances[i] > MOVED * largest),
    )
    if (halves.some((half) => isShrunk(points, moved, half))) continue
    const nearby = inBox(near, moved, movers, TOGETHER * radius)
    const tree = treeOf(moved, nearby, NEIGHBOURS)
    for (const i of movers) {
      const { count, indices, squares } = tree.nearest(moved, 3 * i, TOGETHER * radius)
      for (let k = 0; k < count; k++) {
        const j = nearby[indices[k]]
        if (j === i || components[i] !== components[j]) continue
        const gap = distanceBetween(points, i, j)
        if (!(gap > MIN_GAP * radius && gap > RATIO * Math.sqrt(squares[k]))) continue
        const [first, second] = [vectorAt(points, i), vectorAt(points, j)]
        pairs.push({ first, second, middle: plus(plus([0, 0, 0], first, 0.5), second, 0.5), gap, motion })
      }
    }
  }
  return pairs
}

/** Selects the points in `list` that are within `margin` of the bounding box of `others`. */
function inBox(list: Uint32Array, points: Float64Array, others: Uint32Array, margin: number): Uint32Array {
  const low = [Infinity, Infinity, Infinity]
  const high = [-Infinity, -Infinity, -Infinity]
  for (const i of others) {
    for (let k = 0; k < 3; k++) {
      low[k] = Math.min(low[k], points[3 * i + k] - margin)
      high[k] = Math.max(high[k], points[3 * i + k] + margin)
    }
  }
  return list.filter((i) =>
    [0, 1, 2].every((k) => points[3 * i + k] >= low[k] && points[3 * i + k] <= high[k]),
  )
}

function isShrunk(points: Float64Array, moved: Float64Array, half: Uint32Array): boolean {
  return half.length > 3 && extent(pickPoints(moved, half)) < SHRUNK * extent(pickPoints(points, half))
}

function extent(points: Float64Array): number {
  let most = 0
  for (let k = 0; k < 3; k++) {
    let [low, high] = [Infinity, -Infinity]
    for (let i = k; i < points.length; i += 3) {
      low = Math.min(low, points[i])
      high = Math.max(high, points[i])
    }
    most = Math.max(most, high - low)
  }
  return most
}

/**
 * Finds the eyes: the positions where a target closes lids, away from the symmetry plane and the mouth. The pairs of one eye are mirrored and
 * combined with the pairs of the other eye.
 *
 * @param isAbove returns whether a position is far enough above the mouth to be an eye.
 * @returns centres of both eye openings. The first one is on the side to which the plane's normal points.
 */
export function eyesOf(
  pairs: readonly ClosingPair[],
  { radius }: MovingRegion,
  { origin, normal: x }: MirrorFit,
  mouth: Vector | undefined,
  isAbove: (eye: Vector) => boolean,
): [Vector, Vector] | undefined {
  const offset = (point: Vector) => dotOf(minus(point, origin), x)
  const byMotion = new Map<number, Vector[]>()
  for (const { middle, motion } of pairs) {
    if (mouth && lengthOf(minus(middle, mouth)) < FROM_MOUTH * radius) continue
    const list = byMotion.get(motion) ?? []
    list.push(plus(middle, x, -2 * Math.min(0, offset(middle))))
    byMotion.set(motion, list)
  }
  // Closing lids stay away from the symmetry plane. Folds of the chin also bring points together, but they cross the plane.
  const groups = [...byMotion.values()]
    .map((list) => ({
      all: list.length,
      list: list.filter((point) => offset(point) > MIN_PLANE_DISTANCE * radius),
    }))
    .filter(({ all, list }) => list.length >= MIN_PAIRS && list.length > 0.9 * all)
    .map(({ list }) => list)
    .filter((list) => isAbove(meanOf(list)))
    .sort((a, b) => b.length - a.length)
  if (groups.length === 0) return undefined
  const first = meanOf(groups[0])
  const lids = groups
    .filter((list) => list.length > 0.3 * groups[0].length)
    .filter((list) => lengthOf(minus(meanOf(list), first)) < ONE_EYE * radius)
    .flat()
  // The lids meet from one corner of the eye to the other. The centre is midway between the corners.
  const offsets = lids.map(offset)
  const middle = (quantile(offsets, 0.03) + quantile(offsets, 0.97)) / 2
  const mean = meanOf(lids)
  const eye = plus(mean, x, middle - offset(mean))
  return [eye, plus(eye, x, -2 * middle)]
}

function meanOf(points: readonly Vector[]): Vector {
  return points.reduce<Vector>((sum, point) => plus(sum, point, 1 / points.length), [0, 0, 0])
}
