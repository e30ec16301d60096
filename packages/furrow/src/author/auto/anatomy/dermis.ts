import { lerp } from '../../../math/scalar.ts'

/**
 * Thickness of the dermis at 20 years, in millimetres. `lid` and `temple` are values of women, and `forehead` is the mean of women (0.86) and
 * men (1.17), from Meng et al. 2022, PMC9205051. `nose` is the thinnest skin over the nasal bone, 0.6 mm (Lessard, Daniel 1985, Arch
 * Otolaryngol 111), minus 0.06 mm of epidermis.
 */
export const DERMIS = { lid: 0.58, temple: 0.8, forehead: 1.02, nose: 0.54 } as const

/** Typical thickness under crow's feet, which reach from the lid towards the temple. */
export const CROWS_FEET_DERMIS = lerp(DERMIS.lid, DERMIS.temple, 0.25)

/**
 * Thickness of the dermis at 80 years, relative to its thickness at 20 years. The collagen of skin decreases by 1% per year (Shuster, Black,
 * McVitie 1975, Br J Dermatol 93). Furrow assumes that the thickness decreases by 0.5% per year.
 */
const THINNING = 0.7

/**
 * Returns the thickness of the dermis at an age.
 *
 * @param thickness thickness at 20 years.
 * @param ageFraction age as a number from 0 (20 years) to 1 (80 years).
 */
export function dermisAt(thickness: number, ageFraction: number): number {
  return thickness * lerp(1, THINNING, ageFraction)
}
