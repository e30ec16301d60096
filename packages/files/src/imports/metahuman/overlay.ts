import { power } from 'furrow/internal'

/** Largest distance of the mean colour of a delta map from mid gray, in bytes. */
const TOLERANCE = 12
const MID_GRAY = 128

/** Tells whether a colour map stores changes around mid gray instead of colours of skin. Newer MetaHumans have such maps. */
export function isDeltaColour(colours: Uint8Array): boolean {
  return [0, 1, 2].every((channel) => {
    let sum = 0
    for (let i = channel; i < colours.length; i += 3) sum += colours[i]
    return Math.abs(sum / (colours.length / 3) - MID_GRAY) <= TOLERANCE
  })
}

/**
 * Lays a delta over a colour by the blend mode overlay, in linear space.
 *
 * @param base sRGB bytes.
 * @param delta linear bytes; 128 changes nothing.
 * @returns sRGB bytes.
 */
export function overlaid(base: ArrayLike<number>, delta: ArrayLike<number>): number[] {
  return Array.from(base, (byte, k) => {
    const own = toLinear(byte / 255)
    const change = delta[k] / (2 * MID_GRAY)
    const mixed = own < 0.5 ? 2 * own * change : 1 - 2 * (1 - own) * (1 - change)
    return Math.round(255 * toSrgb(mixed))
  })
}

/** Decodes sRGB (IEC 61966-2-1). */
function toLinear(value: number): number {
  return value <= 0.04045 ? value / 12.92 : power((value + 0.055) / 1.055, 2.4)
}

function toSrgb(value: number): number {
  return value <= 0.0031308 ? 12.92 * value : 1.055 * power(value, 1 / 2.4) - 0.055
}
