import type { SkinRegion } from '../anatomy/region.ts'
import type { AutoSide } from '../anatomy/region-names.ts'
import { unroll } from '../surface/head-chart.ts'
import type { LaidLine } from './laid-line.ts'

/** Factors on the depth in single regions; see `AutoOptions`. */
export type Strengths = Readonly<Partial<Record<AutoSide, number>>>

/** Returns the factor on the depth in an area. The factor of a half takes precedence over the factor of its region. */
export function regionStrength(strengths: Strengths, area: string): number {
  const region = area.replace(/(Left|Right)$/, '')
  return strengths[area as AutoSide] ?? strengths[region as AutoSide] ?? 1
}

/**
 * Applies the factors of regions to the lines that the regions share. Along a line, the influences of the regions blend the factors.
 *
 * @returns the lines, and a factor on the depth of all of them.
 */
export function applyStrengths(
  lines: readonly LaidLine[],
  regions: readonly Pick<SkinRegion, 'name' | 'influence'>[],
  strengths: Strengths,
): { lines: readonly LaidLine[]; factor: number } {
  const factors = regions.map(({ name }) => regionStrength(strengths, name))
  const [first] = factors
  if (factors.every((each) => each === first)) return { lines, factor: first }
  const factor = Math.max(1, ...factors)
  const relativeAt = ([x, y, z]: Float64Array) => {
    const point = unroll(x, y, z)
    const change = regions.reduce(
      (sum, { influence }, i) => sum + (factors[i] - 1) * (influence?.(point) ?? 1),
      0,
    )
    return (1 + change) / factor
  }
  // Only lines of films are shared, and these have relative depths.
  const blended = lines.map(({ relativeDepths = [], ...line }): LaidLine => {
    const at = (i: number) => relativeAt(line.points.subarray(3 * i, 3 * i + 3))
    return { ...line, relativeDepths: relativeDepths.map((depth, i) => depth * at(i)) }
  })
  return { lines: blended, factor }
}
