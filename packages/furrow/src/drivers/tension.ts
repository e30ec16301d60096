import type { TensionDriver } from '../core/driver-types.ts'
import { curveAt } from './curve.ts'
import { areasOf, type Driver } from './driver.ts'

/** Triangles that stand for an area. */
export interface TensionSample {
  area: string
  /** Places of their corners in the list of positions, three each. */
  triangles: ArrayLike<number>
}

/** One driver, bound to its triangles. */
interface Bound {
  /** Index into `areaNames`. */
  area: number
  corners: Uint32Array
  /** Of each triangle at rest: the inverse of its two edges in its own plane, xx, xy, yy (upper triangular). */
  inverses: Float64Array
  driver: TensionDriver
}

/**
 * Activates areas by how far the skin under them is pushed together or pulled apart, whatever deforms it. Each triangle's
 * stretch in its own plane has two principal values; the mean over an area's triangles of 1 - the smaller one (`compression`), or of
 * the larger one - 1 (`stretch`), goes through the driver's curve. A motion that deforms nothing gives 0. Nothing is allocated by
 * `update`.
 */
export class TensionActivation implements Driver {
  readonly areaNames: readonly string[]
  readonly activations: Float32Array
  readonly missing: readonly string[]
  /** What was measured for each driver, before its curve: shares of the length, negative where the opposite happens. */
  readonly measured: Float64Array
  readonly #bound: readonly (Bound | null)[]

  /** @param rest positions at rest of all corners, x, y and z each; in whatever unit, the same as in `update`. */
  constructor(drivers: readonly TensionDriver[], samples: readonly TensionSample[], rest: ArrayLike<number>) {
    const { areaNames, places } = areasOf(drivers)
    this.areaNames = areaNames
    this.activations = new Float32Array(areaNames.length)
    this.measured = new Float64Array(drivers.length)
    this.#bound = drivers.map((driver, i) => {
      const sample = samples.find(({ area }) => area === driver.area)
      const corners = sample ? wholeTriangles(sample.triangles, rest) : new Uint32Array()
      if (corners.length === 0) return null
      return { area: places[i], corners, inverses: inversesOf(corners, rest), driver }
    })
    this.missing = drivers
      .filter((_, i) => !this.#bound[i])
      .map(({ area }) => `triangles for a tension driver of area "${area}"`)
  }

  /**
   * Brings `activations` up to date.
   *
   * @param positions of all corners as the mesh is now deformed.
   */
  update(positions: ArrayLike<number>): void {
    this.activations.fill(0)
    for (let i = 0; i < this.#bound.length; i++) {
      const bound = this.#bound[i]
      if (bound) this.#measure(i, bound, positions)
    }
  }

  #measure(i: number, { area, corners, inverses, driver }: Bound, positions: ArrayLike<number>): void {
    const isStretch = driver.measure === 'stretch'
    const count = corners.length / 3
    let sum = 0
    for (let k = 0; k < count; k++) {
      const a = 3 * corners[3 * k]
      const b = 3 * corners[3 * k + 1]
      const c = 3 * corners[3 * k + 2]
      // Lengths and angle of the two edges now ...
      let uu = 0
      let uv = 0
      let vv = 0
      for (let axis = 0; axis < 3; axis++) {
        const u = positions[b + axis] - positions[a + axis]
        const v = positions[c + axis] - positions[a + axis]
        uu += u * u
        uv += u * v
        vv += v * v
      }
      // ... in the coordinates of the triangle at rest: the right Cauchy-Green tensor, whose eigenvalues are the squares.
      const xx = inverses[3 * k]
      const xy = inverses[3 * k + 1]
      const yy = inverses[3 * k + 2]
      const c00 = xx * xx * uu
      const c01 = xx * (xy * uu + yy * uv)
      const c11 = xy * xy * uu + 2 * xy * yy * uv + yy * yy * vv
      const mean = (c00 + c11) / 2
      const spread = Math.sqrt(((c00 - c11) / 2) ** 2 + c01 * c01)
      sum += isStretch ? Math.sqrt(mean + spread) - 1 : 1 - Math.sqrt(Math.max(0, mean - spread))
    }
    this.measured[i] = sum / count
    this.activations[area] = Math.min(1, this.activations[area] + curveAt(driver.curve, this.measured[i]))
  }
}

/** Those that have an area. */
function wholeTriangles(triangles: ArrayLike<number>, rest: ArrayLike<number>): Uint32Array {
  const whole: number[] = []
  for (let k = 0; k + 2 < triangles.length; k += 3) {
    const corners = [triangles[k], triangles[k + 1], triangles[k + 2]]
    const [along, across, height] = planeOf(corners, rest)
    if (along > 0 && Math.abs(height) > 0 && Number.isFinite(across / along / height)) whole.push(...corners)
  }
  return Uint32Array.from(whole)
}

function inversesOf(corners: Uint32Array, rest: ArrayLike<number>): Float64Array {
  const inverses = new Float64Array(corners.length)
  for (let k = 0; k < corners.length; k += 3) {
    const [along, across, height] = planeOf(corners.subarray(k, k + 3), rest)
    inverses.set([1 / along, -across / (along * height), 1 / height], k)
  }
  return inverses
}

/** A triangle in its own plane: its first edge is (along, 0), its second one (across, height). */
function planeOf([a, b, c]: ArrayLike<number> & Iterable<number>, rest: ArrayLike<number>): number[] {
  let [uu, uv, vv] = [0, 0, 0]
  for (let axis = 0; axis < 3; axis++) {
    const u = rest[3 * b + axis] - rest[3 * a + axis]
    const v = rest[3 * c + axis] - rest[3 * a + axis]
    uu += u * u
    uv += u * v
    vv += v * v
  }
  const along = Math.sqrt(uu)
  const across = uv / along
  return [along, across, Math.sqrt(Math.max(0, vv - across * across))]
}
