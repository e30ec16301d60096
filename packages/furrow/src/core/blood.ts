/**
 * Absorption of blood in skin: optical depths of linear sRGB channels, relative to green.
 *
 * Derived in `test/unit/core/blood.test.ts` from the extinction of haemoglobin at an oxygenation of 0.75 (S. Prahl, "Tabulated Molar
 * Extinction Coefficient for Hemoglobin in Water", OMLC, 1998). The reflection is the dipole model of H. W. Jensen et al. ("A Practical
 * Model for Subsurface Light Transport", 2001). The dermis holds 1% blood; its scattering and bloodless absorption are from S. Jacques
 * ("Skin Optics", OMLC, 1998).
 *
 * The factors hold for all skin tones, because melanin lies above the dermis and transmits a fixed fraction of the light (J. Jimenez et
 * al., "A Practical Appearance Model for Dynamic Facial Color", 2010).
 */
export const BLOOD_ABSORPTION = [0.35, 1, 0.89] as const

/** Byte of a blood map for skin at rest. Full amplitude is 127 above or below. */
export const BLOOD_AT_REST = 128

/** Maximum amplitude, optical depth of green: flushed skin keeps 13% of the green light. The blood in pale skin at rest has less than half. */
export const MAX_BLOOD_AMPLITUDE = 2

/** Tolerance around `BLOOD_AT_REST`, in byte steps: texture filters do not return equal texels bit by bit. */
export const BLOOD_THRESHOLD = 0.01
