import type { StrainMap } from 'furrow/author'

/** Compression that has the last colour; more has it too. */
export const MOST_SHARE = 0.2

/** Colours from no compression to `MOST_SHARE`, evenly apart: five of matplotlib's "inferno" (CC0), whose lightness rises evenly. */
export const SCALE = [
  [0, 0, 4],
  [87, 16, 110],
  [188, 55, 84],
  [249, 142, 9],
  [252, 255, 164],
] as const

/** A map of compression as RGBA bytes; clear where there is no skin. */
export function colourStrain({ data }: StrainMap): Uint8Array {
  const pixels = new Uint8Array(4 * data.length)
  for (const [i, share] of data.entries()) {
    if (Number.isNaN(share)) continue
    const place = (Math.min(share, MOST_SHARE) / MOST_SHARE) * (SCALE.length - 1)
    const first = Math.min(Math.floor(place), SCALE.length - 2)
    for (let k = 0; k < 3; k++) {
      const [from, to] = [SCALE[first][k], SCALE[first + 1][k]]
      pixels[4 * i + k] = Math.round(from + (place - first) * (to - from))
    }
    pixels[4 * i + 3] = 255
  }
  return pixels
}
