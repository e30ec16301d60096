import { cos, sin } from '../../../math/elementary.ts'
import { dot } from '../../../math/vector.ts'
import type { Vector } from '../../../math/vector3.ts'
import { subtreeOf } from '../skeleton/hierarchy.ts'
import { smooth } from '../strain/smooth.ts'
import { compressionTensors, TENSOR_SIZE } from '../surface/tensors.ts'
import { type LimbSkin, pointWeights } from './limb-skin.ts'

export const DEGREE = Math.PI / 180

/** Rotation of a joint, or of a chain of joints that share the angle equally, in one direction. */
export interface JointTurn {
  /** Turned joints, parents first; at most `TENSOR_SIZE`. */
  joints: readonly number[]
  /** Positions about which the joints turn; default: their own. */
  centres?: readonly Vector[]
  /** Joint relative to which drivers measure the rotation of the last turned joint. */
  from: number
  /** Unit axis in the coordinates of the surface. */
  axis: Vector
  /** Angle at which the wrinkles are fully visible, in radians. */
  full: number
}

/** Turn with the weights of its joints, from which poses at any angle are computed. */
export interface TurnedSkin {
  turn: JointTurn
  /** For each point, the weight of each turned joint with everything below it, 0..1. Packed `TENSOR_SIZE` numbers per point. */
  weights: Float64Array
}

/**
 * Spreads the weights of a turn over the surface. Skin weights change within a few edges, where linear blending would fold the surface into
 * itself; skin takes up a bend over a greater length.
 *
 * @param sigma standard deviation of the diffusion in millimetres.
 * @param runs number of turns of the skin, which share a time limit.
 */
export function turnSkin(limb: LimbSkin, turn: JointTurn, sigma: number, runs: number): TurnedSkin {
  const { surface } = limb.prepared
  const weights = new Float64Array(TENSOR_SIZE * surface.areas.length)
  for (const [k, joint] of turn.joints.entries()) {
    const own = pointWeights(limb, subtreeOf(limb.skeleton.joints, joint))
    for (let i = 0; i < own.length; i++) weights[TENSOR_SIZE * i + k] = own[i]
  }
  smooth(surface, weights, sigma, runs)
  return { turn, weights }
}

/** Weights all joints of a turn alike, by a function. */
export function weightedTurn(
  { prepared: { surface } }: LimbSkin,
  turn: JointTurn,
  moved: (point: number) => number,
): TurnedSkin {
  const weights = new Float64Array(TENSOR_SIZE * surface.areas.length)
  for (let point = 0; point < surface.areas.length; point++) {
    const first = TENSOR_SIZE * point
    weights.fill(moved(point), first, first + turn.joints.length)
  }
  return { turn, weights }
}

/**
 * Returns the displacement of each point at a fraction of the full angle. Blends dual quaternions, so that a bend is an arc and nothing
 * collapses (Kavan et al. 2007, Skinning with dual quaternions).
 */
export function turnDisplacements(
  { prepared: { surface }, places }: LimbSkin,
  { turn, weights }: TurnedSkin,
  fraction: number,
): Float64Array {
  const { points } = surface
  const out = new Float64Array(points.length)
  const poses = dualPoses(turn, places, fraction)
  const blend = new Float64Array(8)
  for (let i = 0; i < surface.areas.length; i++) {
    const first = TENSOR_SIZE * i
    if (!(weights[first] > 1e-6)) continue
    blend.fill(0)
    // The part of the weight that no turned joint has stays at rest.
    blend[0] = 1 - Math.min(1, weights[first])
    for (let k = 0; k < poses.length; k++) {
      const below = k + 1 < poses.length ? weights[first + k + 1] : 0
      const weight = Math.max(0, Math.min(1, weights[first + k]) - below)
      for (let n = 0; n < 8; n++) blend[n] += weight * poses[k][n]
    }
    moveBy(out, blend, points, 3 * i)
  }
  return out
}

/** Returns the compression tensors of the skin at a fraction of the full angle, smoothed. */
export function turnTensors(
  limb: LimbSkin,
  turned: TurnedSkin,
  fraction: number,
  sigma: number,
  runs: number,
) {
  const { surface } = limb.prepared
  const tensors = compressionTensors(surface, turnDisplacements(limb, turned, fraction))
  smooth(surface, tensors, sigma, runs)
  return tensors
}

/** Returns the motion of each turned joint as a dual quaternion: w, x, y, z of the real part, then of the dual part. */
function dualPoses(
  { joints, axis, full, centres }: JointTurn,
  places: readonly Vector[],
  fraction: number,
): Float64Array[] {
  const half = (full * fraction) / joints.length / 2
  const [w, s] = [cos(half), sin(half)]
  const turn = Float64Array.of(w, s * axis[0], s * axis[1], s * axis[2])
  let q: Float64Array = Float64Array.of(1, 0, 0, 0)
  let t = [0, 0, 0]
  return joints.map((joint, k) => {
    // Rotation about the joint: p -> turn (p - c) + c, followed by the motion of the joint above.
    const c = centres?.[k] ?? places[joint]
    const moved = rotated(q, c)
    const centre = [0, 1, 2].map((k) => moved[k] + t[k])
    q = multiplied(q, turn)
    const back = rotated(q, c)
    t = centre.map((value, k) => value - back[k])
    const dual = multiplied(Float64Array.of(0, t[0], t[1], t[2]), q)
    return Float64Array.of(...q, ...dual.map((value) => value / 2))
  })
}

function multiplied(a: Float64Array, b: Float64Array): Float64Array {
  return Float64Array.of(
    a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
    a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
    a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
    a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
  )
}

function rotated(q: Float64Array, v: ArrayLike<number>): number[] {
  const p = multiplied(
    multiplied(q, Float64Array.of(0, v[0], v[1], v[2])),
    Float64Array.of(q[0], -q[1], -q[2], -q[3]),
  )
  return [p[1], p[2], p[3]]
}

/** Writes the displacement of a point by a dual quaternion that is not normalised. */
function moveBy(out: Float64Array, b: Float64Array, points: Float64Array, i: number): void {
  const size = Math.sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2] + b[3] * b[3])
  const w = b[0] / size
  const v = [b[1] / size, b[2] / size, b[3] / size]
  const p = [points[i], points[i + 1], points[i + 2]]
  const dualW = b[4] / size
  const dual = [b[5] / size, b[6] / size, b[7] / size]
  const vp = dot(v, p)
  const vv = dot(v, v)
  for (let k = 0; k < 3; k++) {
    const [m, n] = [(k + 1) % 3, (k + 2) % 3]
    const turned = (w * w - vv) * p[k] + 2 * vp * v[k] + 2 * w * (v[m] * p[n] - v[n] * p[m])
    const moved = 2 * (w * dual[k] - dualW * v[k] + v[m] * dual[n] - v[n] * dual[m])
    out[i + k] = turned + moved - p[k]
  }
}
