import type { AgeDriver } from '../../../drivers/age/definition.ts'
import type { SkinRegion } from '../anatomy/region.ts'

/**
 * Age in years, and depth at rest as a fraction of that at 70. Lines at the corners of the eyes form by 35 (Corcuff et al. 1987), deepen
 * fast from 40 and little after 60 (Akazaki et al. 2002).
 */
const AT_REST: readonly (readonly [years: number, fraction: number])[] = [
  [32, 0],
  [40, 0.05],
  [60, 0.85],
  [70, 1],
  [80, 1.05],
]

/**
 * Creates the driver that keeps a region's lines at rest by the input `age`: skin folded for long stays creased.
 *
 * @param years initial age until the application sets the input; undefined hides the lines at rest.
 */
export function ageDriver({ name, atRest }: SkinRegion, years: number | undefined): AgeDriver | undefined {
  if (atRest === undefined) return undefined
  return {
    type: 'age',
    area: name,
    curve: AT_REST.map(([years, fraction]) => [
      years,
      Math.min(1, Math.round(1000 * fraction * atRest) / 1000),
    ]),
    ...(years !== undefined && { initial: years }),
  }
}
