import { ActivationSum } from '../drivers/activation-sum.ts'
import { pointsOf } from '../drivers/curve.ts'
import type { MorphDriver } from '../drivers/morph/definition.ts'
import type { Face } from './face.ts'
import type { FaceDrivers } from './face-drivers.ts'
import { LastInputs } from './last-inputs.ts'

/** Reads the weights of a mesh's blendshapes, in the order of their names. It runs in every frame, and allocates nothing. */
export type ReadWeights = (weights: Float64Array, instance: number) => void

/**
 * Drivers that read blendshapes by the very names that the mesh has, as those of most files do: what `DriverRuntime` does for any driver,
 * without what finds names, orders drivers and filters. Most pages need not fetch that.
 */
export class MorphDrivers implements FaceDrivers<unknown> {
  readonly movedAreas: ReadonlySet<string>
  readonly #drivers: readonly MorphDriver[]
  readonly #names: readonly string[]
  readonly #read: ReadWeights
  readonly #onMissing: () => void
  /** Of one face after another. */
  readonly #weights: Float64Array
  #last: LastInputs | null = null
  /** Per face. */
  readonly #activations: Float32Array[] = []
  /** Indices of the areas that are driven. */
  #areas = new Uint16Array()
  #sum = new ActivationSum([])
  /** The areas for which these were found. */
  #slots: Face['slots'] | null = null

  /**
   * @param names of the mesh's blendshapes, among them all that the drivers read.
   * @param onMissing is called when an area is no longer there; its drivers rest.
   */
  constructor(
    drivers: readonly MorphDriver[],
    names: readonly string[],
    read: ReadWeights,
    onMissing: () => void,
  ) {
    this.movedAreas = new Set(drivers.map(({ area }) => area))
    this.#drivers = drivers
    this.#names = names
    this.#weights = new Float64Array(names.length)
    this.#read = read
    this.#onMissing = onMissing
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
      this.#sum.addTo(this.#activations[i], this.#weights)
    }
  }

  apply(faces: readonly Face[]): void {
    for (let i = 0; i < faces.length; i++) {
      if (!this.#last!.isDue[i]) continue
      const { activations } = faces[i]
      for (let k = 0; k < this.#areas.length; k++) {
        activations.setAt(this.#areas[k], this.#activations[i], this.#areas[k])
      }
      this.#last!.settle(i, faces[i])
    }
  }

  /** Finds the areas, which may be added and removed. */
  #bind({ slots, activations: { names } }: Face): void {
    this.#slots = slots
    const drivers = this.#drivers.filter(({ area }) => names.includes(area))
    const bound = drivers.map(({ area, targets, rule, curve }) => ({
      area: names.indexOf(area),
      links: targets.map((link) => ({
        ...link,
        indices: Uint16Array.of(this.#names.indexOf(link.name)),
        isArea: false,
        points: link.curve && pointsOf(link.curve),
      })),
      rule,
      points: pointsOf(curve),
    }))
    this.#areas = Uint16Array.from(new Set(bound.map(({ area }) => area)))
    this.#sum = new ActivationSum(bound)
    if (drivers.length < this.#drivers.length) this.#onMissing()
  }
}
