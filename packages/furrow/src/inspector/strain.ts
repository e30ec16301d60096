import { principalStretches, restInverse } from '../math/stretch.ts'

/** Absolute strain at which the colour is `COMPRESSED` or `STRETCHED`. Larger strains have the same colour. */
const FULL = 0.3

// Colours of compressed skin, of skin at rest and of stretched skin, in linear RGB.
const COMPRESSED = [0.9, 0.24, 0.04] as const
const REST = [0.2, 0.2, 0.21] as const
const STRETCHED = [0.06, 0.3, 0.85] as const

/**
 * Computes the strain at each vertex of a deformed surface. The strain of a triangle is the principal strain with the larger absolute value.
 * The strain of a vertex is the mean over its triangles, weighted by their area at rest.
 *
 * @param rest xyz of each vertex at rest.
 * @param posed xyz of each vertex in the pose.
 * @param indices three vertices per triangle.
 * @returns strain per vertex. 0 is skin at rest; -0.2 is skin compressed by a fifth.
 */
export function strainOf(
  rest: ArrayLike<number>,
  posed: ArrayLike<number>,
  indices: ArrayLike<number>,
): Float32Array {
  const sums = new Float32Array(rest.length / 3)
  const areas = new Float32Array(rest.length / 3)
  const stretches = new Float64Array(2)
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const [a, b, c] = [indices[t], indices[t + 1], indices[t + 2]]
    const inverse = restInverse(a, b, c, rest)
    if (!inverse) continue
    principalStretches(stretches, inverse, 0, a, b, c, posed)
    const [least, most] = [stretches[0] - 1, stretches[1] - 1]
    const strain = -least > most ? least : most
    // This is twice the area of the triangle at rest: inverse[0] is 1 / base of the triangle, and inverse[2] is 1 / height.
    const area = 1 / (inverse[0] * inverse[2])
    for (const vertex of [a, b, c]) {
      sums[vertex] += area * strain
      areas[vertex] += area
    }
  }
  return sums.map((sum, i) => (areas[i] > 0 ? sum / areas[i] : 0))
}

/** Returns the colour of a strain in linear RGB: orange for compression, blue for stretch. */
export function strainColour(strain: number): [r: number, g: number, b: number] {
  const t = Math.min(1, Math.abs(strain) / FULL)
  const full = strain < 0 ? COMPRESSED : STRETCHED
  const at = (k: number) => REST[k] + t * (full[k] - REST[k])
  return [at(0), at(1), at(2)]
}
