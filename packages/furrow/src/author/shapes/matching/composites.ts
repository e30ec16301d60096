import { descriptorOf, dotAll } from '../fields/field-operations.ts'
import type { ShapeFields } from '../fields/shape-fields.ts'
import type { Match } from './match.ts'

const SWEEPS = 200
// A composite is a shape that is a sum of other shapes, for example a viseme. The best combination of other shapes is subtracted from the
// shape. The remainder is the fraction of the shape's squared motion that is left.
/** Maximum remainder of a composite after subtracting shapes of all ARKit families. */
const EXPLAINED = 0.006
/** Minimum remainder of a composite after subtracting only shapes of the ARKit family that the composite itself matches. */
const MIXED = 0.0003
/** Minimum factor by which a composite's remainder is larger if only its own family is subtracted instead of all families. */
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
