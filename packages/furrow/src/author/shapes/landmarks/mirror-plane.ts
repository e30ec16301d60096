import { cos, sin } from '../../../math/elementary.ts'
import type { KdTree } from '../../../math/kd-tree.ts'
import { dotOf, lengthOf, plus, unit, type Vector, vectorAt } from '../vectors.ts'
import type { MovingRegion } from './moving-region.ts'
import { type MovingSurface, treeOf } from './moving-surface.ts'

/** Symmetry plane of a head. */
export interface MirrorFit {
  origin: Vector
  normal: Vector
  /** Mean distance between mirrored points and the surface, in radii of the moving region (a sphere around the skin that moves). */
  error: number
}

/** Maximum number of points that are mirrored to refine a plane. */
const SAMPLES = 400
/** Maximum number of points that are mirrored to rank the initial planes. */
const COARSE_SAMPLES = 120
/** Maximum number of surface points that mirrored points are compared with. */
const SURFACE = 16_000
/** Number of initial planes. All of them pass through the moving region's centre. */
const DIRECTIONS = 150
/** Number of initial planes that are refined. */
const REFINED = 3
const ITERATIONS = 20
/** Maximum cosine between the normals of two planes that are refined. */
const MAX_COSINE = 0.97
/**
 * Maximum distance from a mirrored point to the surface, in radii of the moving region. Larger distances are clamped, because hair or other
 * parts may have no mirror image.
 */
const MAX_DISTANCE = 0.15

/** Finds the plane across which a head is most symmetric, by iterative closest points (Besl and McKay 1992). */
export function mirrorPlane({ points }: MovingSurface, { centre, radius, near }: MovingRegion): MirrorFit {
  const surface = everyNth(near, SURFACE)
  const tree = treeOf(points, surface)
  const samples = everyNth(surface, SAMPLES)
  const coarse = everyNth(surface, COARSE_SAMPLES)
  const start = (normal: Vector) =>
    measure(points, coarse, tree, radius, { origin: centre, normal, error: 0 })
  const ranked = directions(DIRECTIONS)
    .map(start)
    .sort((a, b) => a.error - b.error)
  // Planes with similar normals would converge to the same plane.
  const distinct = ranked.filter((plane, i) =>
    ranked.slice(0, i).every((better) => Math.abs(dotOf(plane.normal, better.normal)) < MAX_COSINE),
  )
  const refined = distinct
    .slice(0, REFINED)
    .map((plane) => refine(points, samples, surface, tree, radius, plane))
  return refined.reduce((best, plane) => (plane.error < best.error ? plane : best))
}

function everyNth(values: Uint32Array, most: number): Uint32Array {
  const step = Math.max(1, values.length / most)
  return Uint32Array.from(
    { length: Math.floor(values.length / step) },
    (_, i) => values[Math.floor(i * step)],
  )
}

/** Spreads directions over a hemisphere (Fibonacci lattice). */
function directions(count: number): Vector[] {
  return Array.from({ length: count }, (_, i): Vector => {
    const z = 1 - (i + 0.5) / count
    const ring = Math.sqrt(1 - z * z)
    const angle = Math.PI * (1 + Math.sqrt(5)) * i
    return [ring * cos(angle), ring * sin(angle), z]
  })
}

function reflect(p: Vector, { origin, normal }: MirrorFit): Vector {
  return plus(p, normal, -2 * (dotOf(p, normal) - dotOf(origin, normal)))
}

function measure(points: Float64Array, samples: Uint32Array, tree: KdTree, radius: number, plane: MirrorFit) {
  let sum = 0
  for (const i of samples) {
    const { count, squares } = tree.nearest(reflect(vectorAt(points, i), plane), 0, MAX_DISTANCE * radius)
    sum += count > 0 ? Math.sqrt(squares[0]) / radius : MAX_DISTANCE
  }
  return { ...plane, error: sum / samples.length }
}

function refine(
  points: Float64Array,
  samples: Uint32Array,
  surface: Uint32Array,
  tree: KdTree,
  radius: number,
  first: MirrorFit,
): MirrorFit {
  let plane = first
  for (let n = 0; n < ITERATIONS; n++) {
    const pairs: [Vector, Vector][] = []
    for (const i of samples) {
      const p = vectorAt(points, i)
      const { count, indices } = tree.nearest(reflect(p, plane), 0, MAX_DISTANCE * radius)
      if (count > 0) pairs.push([p, vectorAt(points, surface[indices[0]])])
    }
    if (pairs.length < 8) break
    const next = bestPlane(pairs, plane.normal)
    const moved = lengthOf(plus(next.normal, plane.normal, -1))
    plane = next
    if (moved < 1e-5) break
  }
  return measure(points, samples, tree, radius, plane)
}

/**
 * Fits a plane to pairs of points so that the first point of a pair is mirrored close to the second point. The plane's normal n minimises the
 * sum of `dot(n, p) * dot(n, q)` over the pairs (p, q), with p and q relative to their means.
 */
function bestPlane(pairs: readonly [Vector, Vector][], before: Vector): MirrorFit {
  const mean = (side: 0 | 1) =>
    pairs
      .reduce<Vector>((sum, pair) => plus(sum, pair[side]), [0, 0, 0])
      .map((x) => x / pairs.length) as unknown as Vector
  const [p0, q0] = [mean(0), mean(1)]
  const m = new Float64Array(9)
  for (const [p, q] of pairs) {
    for (let i = 0; i < 3; i++)
      for (let j = 0; j < 3; j++)
        m[3 * i + j] += ((p[i] - p0[i]) * (q[j] - q0[j]) + (p[j] - p0[j]) * (q[i] - q0[i])) / 2
  }
  // The minimum is the eigenvector of the lowest eigenvalue. Power iteration on the shifted, negated matrix finds it.
  const shift = m.reduce((sum, x) => sum + Math.abs(x), 0)
  let normal = before
  for (let n = 0; n < 60; n++) {
    const row = (i: number) =>
      shift * normal[i] - (m[3 * i] * normal[0] + m[3 * i + 1] * normal[1] + m[3 * i + 2] * normal[2])
    normal = unit([row(0), row(1), row(2)])
  }
  return { origin: plus(plus([0, 0, 0], p0, 0.5), q0, 0.5), normal, error: 0 }
}
