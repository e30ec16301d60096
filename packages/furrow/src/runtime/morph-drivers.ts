import { type CurvePoints, outputOf, pointsOf } from '../drivers/curve.ts'
import type { MorphDriver } from '../drivers/morph/definition.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'
import type { Face } from './face.ts'
import type { FaceDrivers } from './face-drivers.ts'
import { LastInputs } from './last-inputs.ts'

/** Reads the weights of a mesh's blendshapes, in the order of their names. It runs in every frame, and allocates nothing. */
export type ReadWeights = (weights: Float64Array, instance: number) => void

/** A driver, its area and blendshapes resolved to indices. */
interface BoundDriver {
  area: number
  targets: Uint16Array
  weights: Float64Array
  /** Of its curve. */
  points: CurvePoints
}

/** Whether drivers are those that `MorphDrivers` evaluates: sums of blendshapes, as in most files. */
export function areSums(drivers: readonly WrinkleDriver[]): drivers is readonly MorphDriver[] {
  return (drivers as readonly MorphDriver[]).every(
    ({ type, rule, targets }) => type === 'morph' && rule === 'sum' && targets.every(({ curve }) => !curve),
  )
}

/**
 * Drivers that add up blendshapes, by the very names that the mesh has, as those of most files do: what `DriverRuntime` does for any
 * driver, without what finds names, orders drivers, combines and filters. Most pages need not fetch that.
 */
export class MorphDrivers implements FaceDrivers<unknown> {
  readonly movedAreas: ReadonlySet<string>
  readonly #drivers: readonly MorphDriver[]
  readonly #names: readonly string[]
  readonly #read: ReadWeights
  readonly #onOther: () => void
  /** Whether that was called. */
  #isLeft = false
  /** Of one face after another. */
  readonly #weights: Float64Array
  #last: LastInputs | null = null
  /** Per face. */
  readonly #activations: Float32Array[] = []
  #bound: readonly BoundDriver[] = []
  /** The areas for which these were found. */
  #slots: Face['slots'] | null = null

  /**
   * @param drivers as `areSums` says.
   * @param names of the mesh's blendshapes, among them all that the drivers read.
   * @param onOther is called once when there is something to warn of, which is left to `DriverRuntime`: an area that is no longer there, whose
   *   drivers rest, or a weight that is NaN, which counts as 0.
   */
  constructor(
    drivers: readonly MorphDriver[],
    names: readonly string[],
    read: ReadWeights,
    onOther: () => void,
  ) {
    this.movedAreas = new Set(drivers.map(({ area }) => area))
    this.#drivers = drivers
    this.#names = names
    this.#weights = new Float64Array(names.length)
    this.#read = read
    this.#onOther = onOther
  }

  readInputs(faces: readonly Face[]): void {
    this.#last ??= new LastInputs(faces.length, this.#names.length)
    for (let i = 0; i < faces.length; i++) {
      this.#read(this.#weights, i)
      this.#last.take(i, this.#weights)
    }
  }

  evaluate(faces: readonly Face[]): void {
    if (faces[0].slots !== this.#slots) this.#bind(faces[0])
    for (let i = 0; i < faces.length; i++) {
      if (!this.#last!.check(i, faces[i])) continue
      const { values } = faces[i].resting
      this.#activations[i] ??= new Float32Array(values.length)
      this.#activations[i].set(values)
      this.#last!.get(i, this.#weights)
      this.#addTo(this.#activations[i])
    }
  }

  apply(faces: readonly Face[]): void {
    for (let i = 0; i < faces.length; i++) {
      if (!this.#last!.isDue[i]) continue
      const { activations } = faces[i]
      for (let k = 0; k < this.#bound.length; k++) {
        const { area } = this.#bound[k]
        activations.setAt(area, this.#activations[i], area)
      }
      this.#last!.settle(i, faces[i])
    }
  }

  /** Adds to each area what its drivers give, up to 1. */
  #addTo(areas: Float32Array): void {
    for (let i = 0; i < this.#bound.length; i++) {
      const { area, targets, weights, points } = this.#bound[i]
      let sum = 0
      for (let k = 0; k < targets.length; k++) {
        const weight = this.#weights[targets[k]]
        if (Number.isNaN(weight)) this.#leave()
        else sum += weight * weights[k]
      }
      areas[area] = Math.min(1, areas[area] + outputOf(points, sum))
    }
  }

  /** Finds the areas, which may be added and removed. */
  #bind({ slots, activations: { names } }: Face): void {
    this.#slots = slots
    const drivers = this.#drivers.filter(({ area }) => names.includes(area))
    this.#bound = drivers.map(({ area, targets, curve }) => ({
      area: names.indexOf(area),
      targets: Uint16Array.from(targets, ({ name }) => this.#names.indexOf(name)),
      weights: Float64Array.from(targets, ({ weight }) => weight),
      points: pointsOf(curve),
    }))
    if (drivers.length < this.#drivers.length) this.#leave()
  }

  #leave(): void {
    if (this.#isLeft) return
    this.#isLeft = true
    this.#onOther()
  }
}
