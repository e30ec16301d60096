import { descriptorOf, dotAll } from '../fields/field-operations.ts'
import type { ShapeFields } from '../fields/shape-fields.ts'
import type { Match } from './match.ts'

/** Sweeps of the solver. */
const SWEEPS = 200
/** Fraction of the energy of a composite that its parts leave over at most. */
const EXPLAINED = 0.006
/** Fraction of the energy of a composite that one family of shapes leaves over at least. */
const MIXED = 0.0003
/** Ratio of both at least. */
const GAIN = 4

/** Finds shapes that are sums of shapes of several families, such as visemes and emotions. Returns indices into the shapes. */
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
 * Fraction of the energy of a unit vector that no sum of others with weights from 0 explains, by projected Gauss-Seidel (Murty: Linear
 * Complementarity, 9.3).
 *
 * @param gram products of the others.
 * @param right their products with the vector.
 */
function residualOf(gram: readonly Float64Array[], right: Float64Array, used: readonly number[]): number {
  const weights = new Float64Array(right.length)
  /** Products of the others with the rest of the vector. */
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
