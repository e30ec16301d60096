import type { AgeDriver } from '../../../drivers/age/definition.ts'
import type { SkinRegion } from '../anatomy/region.ts'

/**
 * Depth of lines on the neutral face by age, as a fraction of the depth at 70 years. Lines at the corners of the eyes form by 35 (Corcuff et
 * al. 1987). They deepen fast from 40 to 60, and little after 60 (Akazaki et al. 2002).
 */
const AT_REST: readonly (readonly [years: number, fraction: number])[] = [
  [32, 0],
  [40, 0.05],
  [60, 0.85],
  [70, 1],
  [80, 1.05],
]

/**
 * Creates the driver that shows a region's lines at rest, depending on the input `age`. Old skin stays creased where it often folds.
 *
 * @param years age until the application sets the input `age`. If undefined, no lines are shown at rest until then.
 * @returns undefined if the region's lines vanish at rest at any age.
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
