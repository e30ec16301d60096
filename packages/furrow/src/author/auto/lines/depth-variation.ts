import { noise } from '../../../math/noise.ts'
import { blendNoise } from '../../../math/random-blend.ts'
import { Rng } from '../../../math/rng.ts'
import { clamp, lerp } from '../../../math/scalar.ts'
import { length3 } from '../../../math/vector.ts'
import type { LaidLine } from './laid-line.ts'
import { STEP } from './trace.ts'

/** Random variation of a line's depth at a point, -1..1. */
export type DepthVariation = (point: number) => number

/** Approximate wavelength of the variation, in millimetres. */
const WAVELENGTH = 8

/**
 * Returns the random variation of each line's depth. The more symmetric the face, the more a line on the right has the variation of the line on
 * the left that it mirrors.
 *
 * @param name name of the region. Regions on one side of the face end in `Left` or `Right`.
 * @param symmetry 0..1.
 */
export function depthVariations(
  name: string,
  lines: readonly LaidLine[],
  symmetry: number,
): DepthVariation[] {
  const variationsOf = (region: string) => {
    const rng = new Rng(0, `${region} depth`)
    return lines.map((): DepthVariation => {
      const seed = rng.integer()
      return (point) => noise((point * STEP) / WAVELENGTH, seed)
    })
  }
  const own = variationsOf(name)
  if (symmetry === 0 || name.endsWith('Left')) return own
  const blended = (a: DepthVariation, b: DepthVariation): DepthVariation => {
    return (point) => clamp(blendNoise(a(point), b(point), symmetry), -1, 1)
  }
  if (name.endsWith('Right')) {
    const left = variationsOf(name.replace(/Right$/, 'Left'))
    return own.map((variation, i) => blended(variation, left[i]))
  }
  const middles = lines.map(({ points }) => points.subarray(3 * Math.floor(points.length / 6)))
  return own.map((variation, i) => {
    const mirrored = nearestMirrored(middles, i)
    const last = lines[i].triangles.length - 1
    if (mirrored === i) return (point) => lerp(variation(point), variation(last - point), symmetry / 2)
    return middles[i][0] < 0 ? blended(variation, own[mirrored]) : variation
  })
}

/** Returns the index of the point that is nearest to the mirror image of a point. */
function nearestMirrored(points: readonly Float64Array[], index: number): number {
  const [x, y, z] = points[index]
  const distances = points.map((point) => length3(point[0] + x, point[1] - y, point[2] - z))
  return distances.indexOf(Math.min(...distances))
}
