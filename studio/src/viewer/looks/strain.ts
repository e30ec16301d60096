import { principalStretches, restInverse } from 'furrow/internal'

/** Strain at full colour, and linear RGB of compressed, neutral and stretched skin. */
const FULL = 0.3
const COMPRESSED = [0.9, 0.24, 0.04] as const
const REST = [0.2, 0.2, 0.21] as const
const STRETCHED = [0.06, 0.3, 0.85] as const

/**
 * Measures compression and stretching of a deformed surface. Each vertex gets the mean over its triangles, weighted by area at rest,
 * of the principal strain with the larger magnitude (see `principalStretches`).
 *
 * @param rest packed xyz per vertex at rest.
 * @param posed packed xyz per vertex in the current pose.
 * @param indices three vertices per triangle.
 * @returns strain per vertex: -0.2 for skin compressed by a fifth, 0 at rest.
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
    // 1 / (along * height) is twice the area.
    const area = 1 / (inverse[0] * inverse[2])
    for (const vertex of [a, b, c]) {
      sums[vertex] += area * strain
      areas[vertex] += area
    }
  }
  return sums.map((sum, i) => (areas[i] > 0 ? sum / areas[i] : 0))
}

/** Returns the linear RGB of a strain: orange for compression, blue for stretching. */
export function strainColour(strain: number): [r: number, g: number, b: number] {
  const t = Math.min(1, Math.abs(strain) / FULL)
  const full = strain < 0 ? COMPRESSED : STRETCHED
  const at = (k: number) => REST[k] + t * (full[k] - REST[k])
  return [at(0), at(1), at(2)]
}
