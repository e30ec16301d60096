import { applyCurve } from './curve.ts'
import { areasOf, type Driver } from './driver.ts'
import type { BoneDriver } from './types.ts'

/** Numbers of a matrix, columns first, as three.js's `Matrix4.elements`. */
export const MATRIX = 16

/** Of one driver, bound to its joints. */
interface Bound {
  /** Index into `areaNames`. */
  area: number
  /** Where the matrices of its two joints start. */
  from: number
  joint: number
  /** Turn of the joint at rest as seen from the other: a matrix of 3 x 3, columns first. */
  rest: Float64Array
  /** Of length 1, in the frame of the joint at rest. */
  axis: readonly number[] | null
  driver: BoneDriver
}

/**
 * Activates areas by joints: the angle by which one has turned from its rest as seen from another, or the distance of the two,
 * through the driver's curve. Nothing is allocated by `update`.
 */
export class BoneActivation implements Driver {
  readonly areaNames: readonly string[]
  readonly activations: Float32Array
  readonly missing: readonly string[]
  readonly #bound: readonly Bound[]
  readonly #turn = new Float64Array(9)
  /** What was measured last; in an array, since a number that a function returns may be allocated. */
  readonly #read = new Float64Array(1)

  /**
   * @param joints names, in the order of the matrices.
   * @param rest matrices to the world at rest, 16 numbers for each joint, columns first; their scales do not matter.
   */
  constructor(drivers: readonly BoneDriver[], joints: readonly string[], rest: ArrayLike<number>) {
    const { areaNames, places } = areasOf(drivers)
    const pairs = drivers.map(({ joints: names }) => names.map((name) => joints.indexOf(name)))
    this.areaNames = areaNames
    this.activations = new Float32Array(areaNames.length)
    this.missing = drivers.flatMap(({ area, joints: names }) =>
      names
        .filter((name) => !joints.includes(name))
        .map((name) => `joint "${name}" of a driver of area "${area}"`),
    )
    this.#bound = drivers.flatMap((driver, i) => {
      const [from, joint] = pairs[i].map((place) => place * MATRIX)
      if (from < 0 || joint < 0) return []
      const turn = new Float64Array(9)
      relativeTurn(turn, rest, from, joint)
      const axis = driver.axis ? unit(driver.axis) : null
      return [{ area: places[i], from, joint, rest: turn, axis, driver }]
    })
  }

  /**
   * Brings `activations` up to date.
   *
   * @param matrices to the world now, as `rest`.
   */
  update(matrices: ArrayLike<number>): void {
    this.activations.fill(0)
    for (let i = 0; i < this.#bound.length; i++) {
      const bound = this.#bound[i]
      if (bound.driver.measure === 'distance') readDistance(this.#read, matrices, bound)
      else this.#readAngle(matrices, bound)
      applyCurve(bound.driver.curve, this.#read)
      this.activations[bound.area] = Math.min(1, this.activations[bound.area] + this.#read[0])
    }
  }

  /** Radians: the angle of the turn now after the inverse of that at rest. */
  #readAngle(matrices: ArrayLike<number>, { from, joint, rest, axis }: Bound): void {
    const now = this.#turn
    relativeTurn(now, matrices, from, joint)
    // The turn is rest^T now, in the frame of the joint at rest; half of what is not symmetric in it is the axis times the sine.
    const x = (dot(rest, 2, now, 1) - dot(rest, 1, now, 2)) / 2
    const y = (dot(rest, 0, now, 2) - dot(rest, 2, now, 0)) / 2
    const z = (dot(rest, 1, now, 0) - dot(rest, 0, now, 1)) / 2
    const cosine = (dot(rest, 0, now, 0) + dot(rest, 1, now, 1) + dot(rest, 2, now, 2) - 1) / 2
    if (axis) {
      // The part about the axis (swing and twist): as a quaternion the turn is w = cos(angle / 2) and (x, y, z) / (2 w).
      const along = x * axis[0] + y * axis[1] + z * axis[2]
      this.#read[0] = 2 * Math.atan2(along / 2, Math.max(0, (1 + cosine) / 2))
    } else {
      this.#read[0] = Math.atan2(Math.sqrt(x * x + y * y + z * z), cosine)
    }
  }
}

/** Of two columns. */
function dot(a: Float64Array, i: number, b: Float64Array, j: number): number {
  return a[3 * i] * b[3 * j] + a[3 * i + 1] * b[3 * j + 1] + a[3 * i + 2] * b[3 * j + 2]
}

function readDistance(read: Float64Array, matrices: ArrayLike<number>, { from, joint }: Bound): void {
  const x = matrices[joint + 12] - matrices[from + 12]
  const y = matrices[joint + 13] - matrices[from + 13]
  const z = matrices[joint + 14] - matrices[from + 14]
  read[0] = Math.sqrt(x * x + y * y + z * z)
}

/** The turn of one joint as seen from another: from^T joint, of their columns at length 1. */
function relativeTurn(out: Float64Array, matrices: ArrayLike<number>, from: number, joint: number): void {
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

function unit(axis: readonly number[]): number[] {
  const length = Math.hypot(...axis)
  return axis.map((value) => value / length)
}
