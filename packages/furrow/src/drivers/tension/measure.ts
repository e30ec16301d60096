import { type AtRest, principalStretches, restMatrix } from '../../math/stretch.ts'
import type { InputOf } from '../activation.ts'

/** Triangles on which the tension of an area is measured. */
export interface TensionSample {
  /** Name of the area. */
  area: string
  /** Three indices of vertices per triangle. */
  triangles: ArrayLike<number>
}

/** An input with its triangles. */
interface BoundTension {
  /** Three indices of vertices per triangle. */
  corners: Uint32Array
  /** Result of `restMatrix` for each triangle. */
  inverses: Float64Array
  isStretch: boolean
}

/**
 * Measures the compression or stretch of the skin of areas, as a mean over triangles. A triangle has two principal ratios of deformed length
 * to rest length. Its compression is 1 minus the smaller ratio; its stretch is the larger ratio minus 1. If an input has a direction, only
 * the ratio along this direction is measured. `measure` allocates nothing.
 */
export class TensionMeasurement {
  /** For each input, `['triangles']` if its area has no triangles, otherwise empty. Inputs without triangles are not measured. */
  readonly missing: readonly (readonly string[])[]
  readonly #bound: readonly (BoundTension | null)[]
  readonly #stretches = new Float64Array(2)

  /**
   * @param inputs inputs to measure.
   * @param samples triangles of each area that an input measures. Degenerate triangles are skipped.
   * @param rest xyz of each vertex at rest, in any unit.
   * @param uvs u and v of each vertex; required for inputs with a direction.
   */
  constructor(
    inputs: readonly InputOf<'tension'>[],
    samples: readonly TensionSample[],
    rest: ArrayLike<number>,
    uvs: ArrayLike<number> = [],
  ) {
    this.#bound = inputs.map(({ area, measure, direction }) => {
      const sample = samples.find((own) => own.area === area)
      const { corners, inverses } = measureAtRest(sample?.triangles ?? [], {
        positions: rest,
        uvs,
        direction,
      })
      return corners.length === 0 ? null : { corners, inverses, isStretch: measure === 'stretch' }
    })
    this.missing = this.#bound.map((bound) => (bound ? [] : ['triangles']))
  }

  /**
   * Measures all inputs.
   *
   * @param positions xyz of each deformed vertex, in the unit of `rest`.
   * @param out receives one number per input, as a fraction of the rest length. The number is negative if compression is measured but the
   *   skin stretches, or the reverse.
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

/** Computes the rest matrices of triangles. Skips degenerate triangles. */
function measureAtRest(triangles: ArrayLike<number>, rest: AtRest) {
  const [corners, inverses]: number[][] = [[], []]
  for (let k = 0; k + 2 < triangles.length; k += 3) {
    const [a, b, c] = [triangles[k], triangles[k + 1], triangles[k + 2]]
    const inverse = restMatrix(a, b, c, rest)
    if (!inverse) continue
    corners.push(a, b, c)
    inverses.push(...inverse)
  }
  return { corners: Uint32Array.from(corners), inverses: Float64Array.from(inverses) }
}
