import { along, TENSOR } from './strain.ts'
import type { Surface } from './surface.ts'

type Vector = [x: number, y: number, z: number]

const found = new Float64Array(TENSOR)

/** The tensor at a place of a triangle; filled anew by each call. */
export function tensorAt(
  { corners }: Surface,
  tensors: Float64Array,
  triangle: number,
  shares: ArrayLike<number>,
): Float64Array {
  found.fill(0)
  for (let j = 0; j < 3; j++) {
    const at = TENSOR * corners[3 * triangle + j]!
    for (let k = 0; k < TENSOR; k++) found[k]! += shares[j]! * tensors[at + k]!
  }
  return found
}

/** n x d: at a right angle to a direction of the skin, in the skin, where n is its normal. */
export function crossed(n: ArrayLike<number>, d: ArrayLike<number>): Vector {
  return [n[1]! * d[2]! - n[2]! * d[1]!, n[2]! * d[0]! - n[0]! * d[2]!, n[0]! * d[1]! - n[1]! * d[0]!]
}

/** v . T w */
export function between(t: Float64Array, v: ArrayLike<number>, w: ArrayLike<number>): number {
  return (
    v[0]! * (t[0]! * w[0]! + t[1]! * w[1]! + t[2]! * w[2]!) +
    v[1]! * (t[1]! * w[0]! + t[3]! * w[1]! + t[4]! * w[2]!) +
    v[2]! * (t[2]! * w[0]! + t[4]! * w[1]! + t[5]! * w[2]!)
  )
}

/** The direction in which a place of a triangle is shortened least, and what it loses across it. */
export function principalAt(
  surface: Surface,
  tensors: Float64Array,
  triangle: number,
  shares: ArrayLike<number>,
): { way: Vector; lost: number } {
  const { points, corners } = surface
  const [a, b, c] = [0, 1, 2].map((k) => 3 * corners[3 * triangle + k]!) as [number, number, number]
  const u = [0, 1, 2].map((k) => points[b + k]! - points[a + k]!)
  const v = [0, 1, 2].map((k) => points[c + k]! - points[a + k]!)
  const normal = unit(crossed(u, v))
  const x = unit(u)
  const y = crossed(normal, x)
  const { lost, angle } = largestIn(tensorAt(surface, tensors, triangle, shares), x, y)
  const [cosine, sine] = [Math.cos(angle), Math.sin(angle)]
  const way = [0, 1, 2].map((k) => cosine * y[k]! - sine * x[k]!) as Vector
  return { way, lost }
}

/** What the skin loses at a point in the direction in which it is shortened most. */
export function lossAt({ normals }: Surface, tensors: Float64Array, point: number): number {
  const normal = normals.subarray(3 * point, 3 * point + 3)
  const x = unit(crossed(normal, Math.abs(normal[0]!) < 0.9 ? [1, 0, 0] : [0, 1, 0]))
  const tensor = tensors.subarray(TENSOR * point, TENSOR * (point + 1))
  return largestIn(tensor, x, crossed(normal, x)).lost
}

/**
 * The largest principal value of a tensor in a plane, and by what angle its axis is turned from x to y: those of a symmetric 2 x 2
 * matrix (Mohr's circle).
 *
 * @param x of length 1, as is y: the plane, at a right angle to each other.
 */
function largestIn(t: Float64Array, x: Vector, y: Vector): { lost: number; angle: number } {
  const [xx, xy, yy] = [along(t, 0, ...x), between(t, x, y), along(t, 0, ...y)]
  return { lost: (xx + yy) / 2 + Math.hypot((xx - yy) / 2, xy), angle: 0.5 * Math.atan2(2 * xy, xx - yy) }
}

function unit([x, y, z]: readonly number[]): Vector {
  const length = Math.hypot(x!, y!, z!) || 1
  return [x! / length, y! / length, z! / length]
}
