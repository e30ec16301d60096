/**
 * Blood as absorption: what more or less of it in the skin makes of a linear sRGB colour, by channel, in optical depths per unit that green
 * loses. From the extinction of haemoglobin (S. Prahl, "Tabulated Molar Extinction Coefficient for Hemoglobin in Water", OMLC, 1998) at an
 * oxygenation of 0.75, as the dipole model of H. W. Jensen et al. ("A Practical Model for Subsurface Light Transport", 2001) reflects it
 * from a dermis with the scattering and the bloodless absorption of S. Jacques ("Skin Optics", OMLC, 1998) that holds 1% of blood,
 * integrated over the primaries of sRGB; `test/unit/core/blood.test.ts` derives it. Multiplied, it holds for every skin: melanin lies above,
 * and lets through the same fraction of whatever comes from below (J. Jimenez et al., "A Practical Appearance Model for Dynamic Facial
 * Color", 2010, whose colour of skin is a function of haemoglobin and melanin).
 */
export const BLOOD_ABSORPTION = [0.35, 1, 0.89] as const

/** Byte of a blood map where there is as much as at rest; 127 bytes above and below are the amplitude. */
export const BLOOD_AT_REST = 128

/** Largest amplitude: green light loses all but 13% where skin is flushed so. All blood of pale skin is less than half of that. */
export const MAX_BLOOD_AMPLITUDE = 2

/** Steps of a byte around it that count as at rest too: filters need not give the value of equal texels bit by bit. */
export const BLOOD_THRESHOLD = 0.01
