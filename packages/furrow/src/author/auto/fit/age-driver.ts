import type { AgeDriver } from '../../../drivers/age/definition.ts'
import type { SkinRegion } from '../anatomy/region.ts'

/**
 * Years, and how much of its depth at 70 a line has at rest then. In the corners of the eyes lines are formed by 35 (Corcuff et al. 1987), deepen
 * fast from 40 on and little after 60 (Akazaki et al. 2002).
 */
const AT_REST: readonly (readonly [years: number, fraction: number])[] = [
  [32, 0],
  [40, 0.05],
  [60, 0.85],
  [70, 1],
  [80, 1.05],
]

/**
 * Keeps a region's lines when the face is at rest, by the input `age`: what has been folded for long stays so.
 *
 * @param years of the face until the application sets the input; by default its lines do not show at rest.
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
