/**
 * Absorption of light by additional blood in skin: optical depths for red, green and blue light (linear sRGB), relative to green.
 *
 * The numbers are derived in `test/unit/core/blood.test.ts` from the extinction of haemoglobin at an oxygenation of 0.75 (S. Prahl,
 * "Tabulated Molar Extinction Coefficient for Hemoglobin in Water", OMLC, 1998). The test uses the dipole model of reflection (H. W. Jensen
 * et al., "A Practical Model for Subsurface Light Transport", 2001) and assumes 1% blood in the dermis. The dermis's scattering, and
 * its absorption without blood, are from S. Jacques ("Skin Optics", OMLC, 1998).
 *
 * The numbers are valid for all skin tones. Melanin lies above the dermis and scales the light by a factor that does not depend on the
 * blood (J. Jimenez et al., "A Practical Appearance Model for Dynamic Facial Color", 2010).
 */
export const BLOOD_ABSORPTION = [0.35, 1, 0.89] as const

/** Byte of a blood map where blood does not change. Higher bytes redden the skin, lower bytes make it paler. 255 and 1 have full amplitude. */
export const BLOOD_AT_REST = 128

/** Maximum amplitude of a blood map, as the optical depth for green light. At 2, blood absorbs all but 14% of the green light. */
export const MAX_BLOOD_AMPLITUDE = 2

/** Largest difference from `BLOOD_AT_REST`, in byte steps, that counts as no change. Texture filtering has rounding errors. */
export const BLOOD_THRESHOLD = 0.01
