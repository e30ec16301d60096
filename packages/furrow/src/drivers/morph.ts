import type { CurvePoint, MorphDriver } from '../core/wrinkle-maps.ts'
import { findTargets } from './target-names.ts'

/** One driver, bound to the targets of a mesh. */
interface Bound {
  /** Index into `areaNames`. */
  area: number
  targets: Uint16Array
  weights: Float32Array
  curve: readonly CurvePoint[]
}

/**
 * Activates areas by blendshapes: each driver takes the weighted sum of some targets through its curve, and
 * drivers of one area add up to at most 1. Nothing is allocated by `update`.
 */
export class MorphActivation {
  /** The areas that any driver moves. */
  readonly areaNames: readonly string[]
  /** Activations in the order of `areaNames`, 0..1. */
  readonly activations: Float32Array
  /** Targets that drivers name and the mesh does not have; they count as 0. */
  readonly unknownTargets: readonly string[]

  readonly #bound: readonly Bound[]

  /**
   * @param targetNames names of the mesh's morph targets, in the order of its influences, in any spelling that
   *   `findTargets` knows.
   */
  constructor(drivers: readonly MorphDriver[], targetNames: readonly string[]) {
    const areaNames = [...new Set(drivers.map(({ area }) => area))]
    const unknown = new Set<string>()
    this.#bound = drivers.map(({ area, targets, curve }) => {
      const found = targets.flatMap(({ name, weight }) => {
        const indices = findTargets(name, targetNames)
        if (indices.length === 0) unknown.add(name)
        // A shape split in two halves counts once when both are on.
        return indices.map((target) => ({ target, weight: weight / indices.length }))
      })
      return {
        area: areaNames.indexOf(area),
        targets: Uint16Array.from(found, ({ target }) => target),
        weights: Float32Array.from(found, ({ weight }) => weight),
        curve,
      }
    })
    this.areaNames = areaNames
    this.activations = new Float32Array(areaNames.length)
    this.unknownTargets = [...unknown]
  }

  /**
   * Brings `activations` up to date.
   *
   * @param influences weights of the mesh's targets now, as three.js's `morphTargetInfluences`.
   * @param offset where the first target's weight stands.
   */
  update(influences: ArrayLike<number>, offset = 0): void {
    this.activations.fill(0)
    for (let i = 0; i < this.#bound.length; i++) {
      const { area, targets, weights, curve } = this.#bound[i]
      let input = 0
      for (let k = 0; k < targets.length; k++) input += influences[offset + targets[k]] * weights[k]
      this.activations[area] = Math.min(1, this.activations[area] + curveAt(curve, input))
    }
  }
}

/** A piecewise-linear curve, constant beyond its ends. */
export function curveAt(curve: readonly CurvePoint[], input: number): number {
  if (!(input > curve[0][0])) return curve[0][1]
  for (let i = 1; i < curve.length; i++) {
    if (input > curve[i][0]) continue
    const share = (input - curve[i - 1][0]) / (curve[i][0] - curve[i - 1][0])
    return curve[i - 1][1] * (1 - share) + curve[i][1] * share
  }
  return curve[curve.length - 1][1]
}
