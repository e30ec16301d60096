import { dotOf, minus, plus, quantile, type Vector, vectorAt } from '../vectors.ts'
import type { MirrorFit } from './mirror-plane.ts'
import type { MovingRegion } from './moving-region.ts'
import { distanceBetween, type MovingSurface, treeOf } from './moving-surface.ts'

/** Seam between the lips. */
export interface LipSeam {
  /** Centre of the mouth. */
  centre: Vector
  /** Midpoints of skin points that some target pulls apart. */
  points: readonly Vector[]
}

/** Distances in radii of the moving region. */
const PAIR = 0.12
const PARTED = 0.1
const MIDDLE = 0.25
const BEHIND = 0.6
/** Maximum cosine between normals of skin that faces other skin. */
const FACING = 0.2
/** Minimum distance added by a target, in distances at rest, for a pair to count as parted. */
const STRETCH = 1.5

/** Finds the lip seam: nearby skin of one piece that faces other skin, and that some target pulls apart. */
export function lipSeam(
  { points, normals, pieces, motions }: MovingSurface,
  { centre, radius, near }: MovingRegion,
  { origin, normal: x }: MirrorFit,
  forward: Vector,
): LipSeam | undefined {
  const front = near.filter((i) => dotOf(minus(vectorAt(points, i), centre), forward) > -BEHIND * radius)
  // If two points part, at least one moves half the distance.
  const isMoving = Uint8Array.from(front, (i) =>
    motions.some(({ distances }) => distances[i] > (PARTED / 2) * radius) ? 1 : 0,
  )
  const tree = treeOf(points, front)
  const found: Vector[] = []
  for (const [a, i] of front.entries()) {
    if (!isMoving[a]) continue
    tree.within(points, 3 * i, PAIR * radius, (b) => {
      if (b === a || (isMoving[b] && b < a)) return
      const j = front[b]
      if (pieces[i] !== pieces[j] || dot3(normals, i, normals, j) >= FACING) return
      const gap = distanceBetween(points, i, j)
      const least = Math.max(PARTED * radius, STRETCH * gap)
      const isParted = motions.some(
        ({ distances, offsets }) =>
          distances[i] + distances[j] > least && distanceBetween(offsets, i, j) > least,
      )
      if (isParted) found.push(plus(plus([0, 0, 0], vectorAt(points, i), 0.5), vectorAt(points, j), 0.5))
    })
  }
  const middle = found.filter((point) => Math.abs(dotOf(minus(point, origin), x)) < MIDDLE * radius)
  if (middle.length < 3) return undefined
  // Keep the outermost part, without the cavity behind it.
  const depths = middle.map((point) => dotOf(minus(point, centre), forward))
  const cut = quantile(depths, 0.97) - PAIR * radius
  const outer = middle.filter((_, k) => depths[k] > cut)
  const coordinate = (k: number) =>
    quantile(
      outer.map((point) => point[k]),
      0.5,
    )
  return { centre: [coordinate(0), coordinate(1), coordinate(2)], points: found }
}

function dot3(a: Float64Array, i: number, b: Float64Array, j: number): number {
  return a[3 * i] * b[3 * j] + a[3 * i + 1] * b[3 * j + 1] + a[3 * i + 2] * b[3 * j + 2]
}
