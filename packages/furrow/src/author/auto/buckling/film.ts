import { power } from '../../../math/elementary.ts'

/**
 * Stiffness of the film (epidermis and dermis), divided by the stiffness of the base below it. The same ratio is used for the whole body.
 */
const STIFFNESS_RATIO = 30

/**
 * Compression at which a stiff film on a soft base buckles: (3 / ratio)^(2/3) / 4, about 5.4%.
 * Source: Chen, Hutchinson 2004, Herringbone buckling patterns of compressed thin films on compliant substrates, J Appl Mech 71.
 */
export const CRITICAL_COMPRESSION = power(3 / STIFFNESS_RATIO, 2 / 3) / 4

/**
 * Returns the distance between wrinkles: 2 pi h (ratio / 3)^(1/3), same source as `CRITICAL_COMPRESSION`.
 *
 * @param thickness h of the film in millimetres.
 */
export function filmWavelength(thickness: number): number {
  return 2 * Math.PI * thickness * power(STIFFNESS_RATIO / 3, 1 / 3)
}
