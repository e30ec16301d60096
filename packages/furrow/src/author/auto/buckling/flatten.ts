import { clamp } from '../../../math/scalar.ts'
import { cross, dot, length, length2 } from '../../../math/vector.ts'
import { LaplaceSystem } from './laplace-system.ts'

/** Number of iterations. Each iteration computes the rotations of the triangles, then the positions of the points. */
const ITERATIONS = 20
/** Cotangents, which are the weights of edges, are clamped to this range, so that needle-like triangles do not dominate. */
const COTANGENTS = [0.02, 20] as const

/**
 * Flattens triangles as rigidly as possible: rotates each triangle to fit the flat positions, then fits the positions to the rotated
 * triangles by least squares, and repeats (Liu et al. 2008, A Local/Global Approach to Mesh Parameterization).
 *
 * @param positions packed xyz per point of the surface.
 * @param points indices of the points in the surface.
 * @param corners three indices into `points` per triangle. The triangles must be connected.
 * @param initial packed x, y per point.
 * @returns packed x, y per point, placed and oriented like `initial`.
 */
export function flatten(
  positions: Float64Array,
  points: Uint32Array,
  corners: Uint32Array,
  initial: Float64Array,
): Float64Array {
  const shapes = rigidShapes(positions, points, corners, isMirrored(corners, initial))
  const system = new LaplaceSystem(corners, cotangents(shapes), points.length)
  const flat = initial.slice()
  const [right, x, y] = [new Float64Array(flat.length), halves(flat, 0), halves(flat, 1)]
  for (let iteration = 0; iteration < ITERATIONS; iteration++) {
    rotatedEdges(corners, shapes, system.weights, flat, right)
    system.solve(halves(right, 0), x)
    system.solve(halves(right, 1), y)
    for (let i = 0; i < points.length; i++) {
      flat[2 * i] = x[i]
      flat[2 * i + 1] = y[i]
    }
  }
  return flat
}

/** Returns the edges of each triangle in its own plane: x, y from each corner to the next one, packed six numbers per triangle. */
function rigidShapes(
  positions: Float64Array,
  points: Uint32Array,
  corners: Uint32Array,
  mirror: boolean,
): Float64Array {
  const shapes = new Float64Array(2 * corners.length)
  const [u, v, normal] = [new Float64Array(3), new Float64Array(3), new Float64Array(3)]
  for (let t = 0; t < corners.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * points[corners[t + k]])
    for (let k = 0; k < 3; k++) {
      u[k] = positions[b + k] - positions[a + k]
      v[k] = positions[c + k] - positions[a + k]
    }
    cross(normal, u, v)
    const base = length(u)
    const offset = dot(u, v) / base
    const height = ((mirror ? -1 : 1) * length(normal)) / base
    shapes.set([base, 0, offset - base, height, -offset, -height], 2 * t)
  }
  return shapes
}

/** Returns, for each edge, the cotangent of the angle opposite the edge. */
function cotangents(shapes: Float64Array): Float64Array {
  return Float64Array.from({ length: shapes.length / 2 }, (_, i) => {
    const first = i - (i % 3)
    const p = 2 * (first + ((i + 1) % 3))
    const q = 2 * (first + ((i + 2) % 3))
    // The two other edges meet at the opposite corner. The minus sign is needed because only one of them points towards this corner.
    const cosine = -(shapes[p] * shapes[q] + shapes[p + 1] * shapes[q + 1])
    const sine = Math.abs(shapes[p] * shapes[q + 1] - shapes[p + 1] * shapes[q])
    return clamp(cosine / sine, ...COTANGENTS)
  })
}

/**
 * Rotates each triangle so that it fits its flat positions best. Writes the right side of the least-squares system to `out`. For each point, it is
 * the sum of the rotated, weighted edges that end there, minus the sum of the edges that start there.
 */
function rotatedEdges(
  corners: Uint32Array,
  shapes: Float64Array,
  weights: Float64Array,
  flat: Float64Array,
  out: Float64Array,
): void {
  out.fill(0)
  for (let t = 0; t < corners.length; t += 3) {
    let cosine = 0
    let sine = 0
    for (let k = 0; k < 3; k++) {
      const i = 2 * corners[t + k]
      const j = 2 * corners[t + ((k + 1) % 3)]
      const x = flat[j] - flat[i]
      const y = flat[j + 1] - flat[i + 1]
      const a = shapes[2 * (t + k)]
      const b = shapes[2 * (t + k) + 1]
      cosine += weights[t + k] * (a * x + b * y)
      sine += weights[t + k] * (a * y - b * x)
    }
    const size = length2(cosine, sine) || 1
    cosine /= size
    sine /= size
    for (let k = 0; k < 3; k++) {
      const i = 2 * corners[t + k]
      const j = 2 * corners[t + ((k + 1) % 3)]
      const a = shapes[2 * (t + k)]
      const b = shapes[2 * (t + k) + 1]
      const x = weights[t + k] * (cosine * a - sine * b)
      const y = weights[t + k] * (sine * a + cosine * b)
      out[i] -= x
      out[i + 1] -= y
      out[j] += x
      out[j + 1] += y
    }
  }
}

/** Returns whether clockwise triangles cover most of the flat area. */
function isMirrored(corners: Uint32Array, flat: Float64Array): boolean {
  let area = 0
  for (let t = 0; t < corners.length; t += 3) {
    const [a, b, c] = [2 * corners[t], 2 * corners[t + 1], 2 * corners[t + 2]]
    area +=
      (flat[b] - flat[a]) * (flat[c + 1] - flat[a + 1]) - (flat[b + 1] - flat[a + 1]) * (flat[c] - flat[a])
  }
  return area < 0
}

/** Returns every second number, starting with the first or the second one. */
function halves(packed: Float64Array, first: 0 | 1): Float64Array {
  return Float64Array.from({ length: packed.length / 2 }, (_, i) => packed[2 * i + first])
}
