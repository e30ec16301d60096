import { quantile } from '../../../math/quantile.ts'
import { dotOf, minus, plus, type Vector, vectorAt } from '../vectors.ts'
import type { MirrorFit } from './mirror-plane.ts'
import type { MovingRegion } from './moving-region.ts'
import { distanceBetween, type MovingSurface, treeOf } from './moving-surface.ts'

/** Line along which the lips touch. */
export interface LipSeam {
  /** Centre of the mouth. */
  centre: Vector
  /** Midpoints between points of the upper and the lower lip that a target pulls apart. */
  points: readonly Vector[]
}

// Distances are in units of `MovingRegion.radius`.
/** Maximum distance at rest between two points on opposite lips. */
const PAIR = 0.12
/** Minimum distance that a target adds between two points on opposite lips. */
const PARTED = 0.1
/** Maximum distance of the mouth's centre from the symmetry plane. */
const MIDDLE = 0.25
/** Points are ignored if their distance behind the moving region's centre exceeds this. */
const BEHIND = 0.6
/** Maximum cosine between the normals of two lips that face each other. */
const FACING = 0.2
/** Minimum distance that a target adds between two points, as a multiple of their distance at rest. */
const STRETCH = 1.5

/** Finds the lip seam: pairs of nearby points of one connected component that face each other and that a target pulls apart. */
export function lipSeam(
  { points, normals, components, motions }: MovingSurface,
  { centre, radius, near }: MovingRegion,
  { origin, normal: x }: MirrorFit,
  forward: Vector,
): LipSeam | undefined {
  const front = near.filter((i) => dotOf(minus(vectorAt(points, i), centre), forward) > -BEHIND * radius)
  // When a target pulls two points apart, at least one of them moves by half the added distance or more.
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
      if (components[i] !== components[j] || dot3(normals, i, normals, j) >= FACING) return
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
  // The lips are the foremost points; the others are inside the mouth.
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
