import { principalStretches, restInverse } from '../math/stretch.ts'
import { applyCurve } from './curve.ts'
import { areasOf, type Driver } from './driver.ts'
import type { TensionDriver } from './types.ts'

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
  /** Three numbers of each triangle at rest. */
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
  readonly #stretches = new Float64Array(2)

  /** @param rest positions at rest of all corners, x, y and z each; in whatever unit, the same as in `update`. */
  constructor(drivers: readonly TensionDriver[], samples: readonly TensionSample[], rest: ArrayLike<number>) {
    const { areaNames, places } = areasOf(drivers)
    this.areaNames = areaNames
    this.activations = new Float32Array(areaNames.length)
    this.measured = new Float64Array(drivers.length)
    this.#bound = drivers.map((driver, i) => {
      const sample = samples.find(({ area }) => area === driver.area)
      const { corners, inverses } = measureAtRest(sample?.triangles ?? [], rest)
      return corners.length === 0 ? null : { area: places[i], corners, inverses, driver }
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
    for (let i = 0; i < this.#bound.length; i++) {
      const bound = this.#bound[i]
      if (bound) this.#measure(i, bound, positions)
    }
    this.#activate()
  }

  /**
   * Brings `activations` up to date with what was measured elsewhere.
   *
   * @param measured as the property of that name; drivers without triangles are passed over.
   */
  takeMeasured(measured: ArrayLike<number>): void {
    for (let i = 0; i < this.#bound.length; i++) if (this.#bound[i]) this.measured[i] = measured[i]
    this.#activate()
  }

  #measure(i: number, { corners, inverses, driver }: Bound, positions: ArrayLike<number>): void {
    const isStretch = driver.measure === 'stretch'
    const count = corners.length / 3
    const stretches = this.#stretches
    let sum = 0
    for (let k = 0; k < corners.length; k += 3) {
      principalStretches(stretches, inverses, k, corners[k], corners[k + 1], corners[k + 2], positions)
      sum += isStretch ? stretches[1] - 1 : 1 - stretches[0]
    }
    this.measured[i] = sum / count
  }

  #activate(): void {
    this.activations.fill(0)
    for (let i = 0; i < this.#bound.length; i++) {
      const bound = this.#bound[i]
      if (!bound) continue
      const { area, driver } = bound
      this.#stretches[0] = this.measured[i]
      applyCurve(driver.curve, this.#stretches)
      this.activations[area] = Math.min(1, this.activations[area] + this.#stretches[0])
    }
  }
}

/** Leaves out triangles that have no surface. */
function measureAtRest(triangles: ArrayLike<number>, rest: ArrayLike<number>) {
  const [corners, inverses]: number[][] = [[], []]
  for (let k = 0; k + 2 < triangles.length; k += 3) {
    const inverse = restInverse(triangles[k], triangles[k + 1], triangles[k + 2], rest)
    if (!inverse) continue
    corners.push(triangles[k], triangles[k + 1], triangles[k + 2])
    inverses.push(...inverse)
  }
  return { corners: Uint32Array.from(corners), inverses: Float64Array.from(inverses) }
}
