import type { AgeDriver } from '../../../drivers/age/definition.ts'

/**
 * Fraction of the height at 80 years, by age. Lower lids grow throughout adult life, because the fat of the orbit does (Darcy et al. 2008, Plast
 * Reconstr Surg 122). Cheeks and lower lids sag visibly from middle age on (Ezure et al. 2011, Skin Res Technol 17). The numbers are estimates.
 */
const CURVE: AgeDriver['curve'] = [
  [35, 0],
  [50, 0.35],
  [70, 0.85],
  [80, 1],
]

/** Age in years up to which no bulge shows. */
export const BULGES_FROM = CURVE[0][0]

/**
 * Creates the driver that raises a bulge, depending on the input `age`.
 *
 * @param initial age until the application sets the input.
 */
export function bulgeDriver(area: string, initial: number): AgeDriver {
  return { type: 'age', area, curve: CURVE, initial }
}
