import { principalStretches, restInverse } from '../../math/stretch.ts'
import type { InputOf } from '../activation.ts'

/** Triangles that represent an area. */
export interface TensionSample {
  area: string
  /** Three indices of positions per triangle. */
  triangles: ArrayLike<number>
}

/** One input, bound to its triangles. */
interface BoundTension {
  corners: Uint32Array
  /** `restInverse` of each triangle. */
  inverses: Float64Array
  isStretch: boolean
}

/**
 * Measures how far the skin under areas is pushed together or pulled apart, whatever deforms it. Each triangle's stretch in its
 * own plane has two principal values; the result is the mean over an area's triangles of 1 - the smaller one (`compression`),
 * or of the larger one - 1 (`stretch`). A rigid motion gives 0. Nothing is allocated by `measure`.
 */
export class TensionMeasurement {
  /** Per input: `triangles` where its area has none, for people. Such an input is not measured. */
  readonly missing: readonly (readonly string[])[]
  readonly #bound: readonly (BoundTension | null)[]
  readonly #stretches = new Float64Array(2)

  /** @param rest positions at rest of all corners, x, y and z each; in any unit, the same as in `measure`. */
  constructor(
    inputs: readonly InputOf<'tension'>[],
    samples: readonly TensionSample[],
    rest: ArrayLike<number>,
  ) {
    this.#bound = inputs.map(({ area, measure }) => {
      const sample = samples.find((own) => own.area === area)
      const { corners, inverses } = measureAtRest(sample?.triangles ?? [], rest)
      return corners.length === 0 ? null : { corners, inverses, isStretch: measure === 'stretch' }
    })
    this.missing = this.#bound.map((bound) => (bound ? [] : ['triangles']))
  }

  /**
   * @param positions of all corners as the mesh is deformed now.
   * @param out one number per input: a fraction of the length, negative where the opposite happens.
   */
  measure(positions: ArrayLike<number>, out: Float64Array): void {
    for (let i = 0; i < this.#bound.length; i++) {
      const bound = this.#bound[i]
      if (bound) this.#measureOne(out, i, bound, positions)
    }
  }

  #measureOne(
    out: Float64Array,
    i: number,
    { corners, inverses, isStretch }: BoundTension,
    positions: ArrayLike<number>,
  ): void {
    const stretches = this.#stretches
    let sum = 0
    for (let k = 0; k < corners.length; k += 3) {
      principalStretches(stretches, inverses, k, corners[k], corners[k + 1], corners[k + 2], positions)
      sum += isStretch ? stretches[1] - 1 : 1 - stretches[0]
    }
    out[i] = sum / (corners.length / 3)
  }
}

/** Leaves out degenerate triangles. */
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
