import { type AtRest, principalStretches, restMatrix } from '../../math/stretch.ts'
import type { InputOf } from '../activation.ts'

/** Triangles that represent an area. */
export interface TensionSample {
  /** Name of the area. */
  area: string
  /** Three indices of vertices per triangle. */
  triangles: ArrayLike<number>
}

/** One input, bound to its triangles. */
interface BoundTension {
  corners: Uint32Array
  /** `restMatrix` of each triangle. */
  inverses: Float64Array
  isStretch: boolean
}

/**
 * Measures the compression or stretch of the skin under areas, as a mean over triangles. Compression is 1 minus the smaller principal
 * stretch, and stretch is the larger one minus 1. With a direction, the stretch along it replaces both. A rigid motion gives 0. The method
 * `measure` allocates nothing.
 */
export class TensionMeasurement {
  /** Per input: `triangles` if the area has none, for warnings. Inputs without triangles are not measured. */
  readonly missing: readonly (readonly string[])[]
  readonly #bound: readonly (BoundTension | null)[]
  readonly #stretches = new Float64Array(2)

  /**
   * @param inputs inputs to measure, as in `DriverPlan.inputs.tension`.
   * @param samples triangles of the inputs' areas; degenerate triangles are skipped.
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
   * @param out receives one fraction of the rest length per input, negative for the opposite strain.
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

/** Computes the rest matrices of triangles; skips degenerate ones. */
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
