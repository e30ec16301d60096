import { Conflicts } from './conflict.ts'
import { areasOf, type Driver } from './driver.ts'
import { BoundLinks, type Joined } from './links.ts'
import { targetFinder } from './target-names.ts'
import type { ConflictDriver, MorphDriver } from './types.ts'

/**
 * Activates areas by blendshapes: each driver joins its links by its rule and takes the result through its curve; drivers
 * of one area add up to at most 1. Nothing is allocated by `update`.
 */
export class MorphActivation implements Driver {
  readonly areaNames: readonly string[]
  readonly activations: Float32Array
  readonly missing: readonly string[]
  readonly #links: BoundLinks
  readonly #conflicts: Conflicts

  /**
   * @param targetNames names of the mesh's morph targets, in the order of its influences, in any spelling that
   *   `findTargets` knows.
   * @param conflicts resolved in their order, before anything is read.
   */
  constructor(
    drivers: readonly MorphDriver[],
    targetNames: readonly string[],
    conflicts: readonly ConflictDriver[] = [],
  ) {
    const { areaNames, places } = areasOf(drivers)
    const find = targetFinder(targetNames)
    const linked = drivers.map(({ targets, rule, curve }, i) => ({
      area: places[i],
      links: targets,
      rule,
      curve,
    }))
    this.#links = new BoundLinks(linked, find, 'MorphActivation')
    this.#conflicts = new Conflicts(conflicts, find, targetNames.length)
    this.areaNames = areaNames
    this.activations = new Float32Array(areaNames.length)
    this.missing = [
      ...this.#links.unknown.map(
        ({ name, area }) => `target "${name}" of a driver of area "${areaNames[area]}"`,
      ),
      ...this.#conflicts.unknown.map((name) => `target "${name}" of a conflict`),
    ]
  }

  /**
   * Brings `activations` up to date.
   *
   * @param influences weights of the mesh's targets now, as three.js's `morphTargetInfluences`. NaN counts as 0, with one warning.
   * @param offset where the first target's weight stands.
   */
  update(influences: ArrayLike<number>, offset = 0): void {
    this.activations.fill(0)
    if (this.#conflicts.any) {
      this.#links.addTo(this.activations, this.#conflicts.resolve(influences, offset), 0)
    } else {
      this.#links.addTo(this.activations, influences, offset)
    }
  }
  /** What one driver makes of the weights, by its place in the list. For looking: it allocates. */
  explain(driver: number, influences: ArrayLike<number>): Joined {
    return this.#links.explain(
      driver,
      this.#conflicts.any ? this.#conflicts.resolve(influences, 0) : influences,
    )
  }
}
