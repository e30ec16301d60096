import type { InputOf } from '../activation.ts'

/** Numbers per matrix. Matrices are 4 x 4, column-major, like `Matrix4.elements` of three.js. */
export const MATRIX = 16

type JointInput = InputOf<'joint'>

/** An input with the locations of its joints' matrices. */
interface BoundJoint {
  /** Offset of the reference joint's matrix in the array of matrices. */
  from: number
  /** Offset of the measured joint's matrix. */
  joint: number
  /** Rest rotation of the joint relative to the reference: 3 x 3, column-major. */
  rest: Float64Array
  /** Axis of a signed angle: unit vector in the rest frame of the joint. Null for the total rotation. */
  axis: readonly number[] | null
  measure: JointInput['measure']
}

/** Measures rotations of joints in radians, and distances between joints in metres. `measure` allocates nothing. */
export class JointMeasurement {
  /** For each input, the missing joints, as text for warnings. Inputs with missing joints are not measured. */
  readonly missing: readonly (readonly string[])[]
  readonly #bound: readonly (BoundJoint | null)[]
  readonly #rotation = new Float64Array(9)

  /**
   * @param inputs inputs to measure.
   * @param joints names of all joints, in the order of their matrices.
   * @param restFor returns, for an input, the world matrices of all joints in the rest pose. Each matrix is 16 numbers, column-major, with
   *   positions in metres. Scales are ignored.
   */
  constructor(
    inputs: readonly JointInput[],
    joints: readonly string[],
    restFor: (input: JointInput) => ArrayLike<number>,
  ) {
    this.missing = inputs.map(({ from, joint }) =>
      [from, joint].filter((name) => !joints.includes(name)).map((name) => `joint "${name}"`),
    )
    this.#bound = inputs.map((input) => {
      const { measure, axis, ...names } = input
      const [from, joint] = [names.from, names.joint].map((name) => joints.indexOf(name) * MATRIX)
      if (from < 0 || joint < 0) return null
      const rotation = new Float64Array(9)
      relativeRotation(rotation, restFor(input), from, joint)
      return { from, joint, rest: rotation, axis: axis ? normalize(axis) : null, measure }
    })
  }

  /**
   * Measures all inputs.
   *
   * @param matrices current world matrices of all joints, in the layout of `restFor`.
   * @param out receives one number per input.
   */
  measure(matrices: ArrayLike<number>, out: Float64Array): void {
    for (let i = 0; i < this.#bound.length; i++) {
      const bound = this.#bound[i]
      if (bound === null) continue
      if (bound.measure === 'distance') measureDistance(out, i, matrices, bound)
      else this.#measureAngle(out, i, matrices, bound)
    }
  }

  /** Measures the angle between the current rotation and the rest rotation. */
  #measureAngle(out: Float64Array, i: number, matrices: ArrayLike<number>, bound: BoundJoint): void {
    const { from, joint, rest, axis } = bound
    const current = this.#rotation
    relativeRotation(current, matrices, from, joint)
    // Relative to the rest frame of the joint, the rotation is R = transpose(rest) * current. The antisymmetric part of R contains the
    // vector (x, y, z) = axis * sin(angle). The trace of R is 1 + 2 * cos(angle).
    const x = (dot(rest, 2, current, 1) - dot(rest, 1, current, 2)) / 2
    const y = (dot(rest, 0, current, 2) - dot(rest, 2, current, 0)) / 2
    const z = (dot(rest, 1, current, 0) - dot(rest, 0, current, 1)) / 2
    const cosine = (dot(rest, 0, current, 0) + dot(rest, 1, current, 1) + dot(rest, 2, current, 2) - 1) / 2
    if (axis) {
      // Angle of the twist about `axis` (swing-twist decomposition). The quaternion of R is w = cos(angle / 2), v = (x, y, z) / (2 * w).
      // The twist angle is 2 * atan2(dot(v, axis), w). Both arguments are multiplied by w below.
      const along = x * axis[0] + y * axis[1] + z * axis[2]
      out[i] = 2 * Math.atan2(along / 2, Math.max(0, (1 + cosine) / 2))
    } else {
      out[i] = Math.atan2(Math.sqrt(x * x + y * y + z * z), cosine)
    }
  }
}

/** Returns the dot product of column `i` of `a` and column `j` of `b`. */
function dot(a: Float64Array, i: number, b: Float64Array, j: number): number {
  return a[3 * i] * b[3 * j] + a[3 * i + 1] * b[3 * j + 1] + a[3 * i + 2] * b[3 * j + 2]
}

function measureDistance(
  out: Float64Array,
  i: number,
  matrices: ArrayLike<number>,
  { from, joint }: BoundJoint,
): void {
  const x = matrices[joint + 12] - matrices[from + 12]
  const y = matrices[joint + 13] - matrices[from + 13]
  const z = matrices[joint + 14] - matrices[from + 14]
  out[i] = Math.sqrt(x * x + y * y + z * z)
}

/** Computes the rotation of a joint relative to a reference joint: `transpose(from) * joint`, from matrices with normalised columns. */
function relativeRotation(out: Float64Array, matrices: ArrayLike<number>, from: number, joint: number): void {
  for (let column = 0; column < 3; column++) {
    for (let row = 0; row < 3; row++) {
      let sum = 0
      let fromLength = 0
      let jointLength = 0
      for (let k = 0; k < 3; k++) {
        const a = matrices[from + 4 * row + k]
        const b = matrices[joint + 4 * column + k]
        sum += a * b
        fromLength += a * a
        jointLength += b * b
      }
      out[3 * column + row] = sum / Math.sqrt(fromLength * jointLength)
    }
  }
}

function normalize(axis: readonly number[]): number[] {
  const length = Math.hypot(...axis)
  return axis.map((value) => value / length)
}
