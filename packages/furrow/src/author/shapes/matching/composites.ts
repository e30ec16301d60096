import { descriptorOf, dotAll } from '../fields/field-operations.ts'
import type { ShapeFields } from '../fields/shape-fields.ts'
import type { Match } from './match.ts'

const SWEEPS = 200
// A composite is a shape that is a sum of other shapes, for example a viseme.
/** After subtracting the best combination of all other shapes, at most this fraction of a composite's squared motion remains. */
const EXPLAINED = 0.006
/** After subtracting other shapes with labels of the same family, at least this fraction of a composite's squared motion remains. */
const MIXED = 0.0003
/** Minimum ratio of the remainder after subtracting the same family (`MIXED`) to the remainder after subtracting all shapes (`EXPLAINED`). */
const GAIN = 4

/**
 * Finds composites: shapes that are sums of other shapes from several ARKit families, such as visemes and emotions.
 *
 * @returns indices of the composites in `shapes`.
 */
export function compositesOf({ shapes, weights }: ShapeFields, matches: readonly Match[]): Set<number> {
  const units = matches.map(({ shape }) => descriptorOf(shapes[shape].field, weights).plain)
  const gram = units.map((a) => Float64Array.from(units, (b) => dotAll(a, b)))
  const composites = new Set<number>()
  for (const [n, { shape, label }] of matches.entries()) {
    const others = [...matches.keys()].filter((k) => k !== n)
    const family = others.filter((k) => matches[k].label.family === label.family)
    const own = residualOf(gram, gram[n], family)
    const all = own > MIXED ? residualOf(gram, gram[n], others) : own
    if (own > Math.max(MIXED, GAIN * all) && all < EXPLAINED) composites.add(shape)
  }
  return composites
}

/**
 * Returns the squared length that remains of a unit vector after subtracting the best nonnegative combination of other unit vectors. The
 * method is projected Gauss-Seidel (Murty: Linear Complementarity, 9.3).
 *
 * @param gram dot products between the other vectors.
 * @param right dot products of the other vectors with the unit vector.
 * @param used indices of the other vectors that may be combined.
 */
function residualOf(gram: readonly Float64Array[], right: Float64Array, used: readonly number[]): number {
  const weights = new Float64Array(right.length)
  /** Dot products of the other vectors with the current remainder. */
  const rest = right.slice()
  for (let sweep = 0; sweep < SWEEPS; sweep++) {
    for (const i of used) {
      const step = Math.max(rest[i], -weights[i])
      if (step === 0) continue
      weights[i] += step
      for (const j of used) rest[j] -= step * gram[i][j]
    }
  }
  let energy = 1
  for (const i of used) energy -= weights[i] * (right[i] + rest[i])
  return energy
}
