import type { StrainMap } from 'furrow/internal'

/**
 * Lowest compression that gets the last colour of the scale, as a fraction of the length at rest.
 */
export const MAX_COMPRESSION = 0.2

/**
 * Five equidistant sRGB colours of the perceptually uniform colour map "inferno" (matplotlib, CC0). The first colour
 * stands for compression 0, and the last colour for `MAX_COMPRESSION`.
 */
export const COLOUR_SCALE = [
  [0, 0, 4],
  [87, 16, 110],
  [188, 55, 84],
  [249, 142, 9],
  [252, 255, 164],
] as const

/** Converts a map of skin compression to RGBA bytes. Texels without skin (NaN) become transparent. */
export function colourStrain({ data }: StrainMap): Uint8Array {
  const pixels = new Uint8Array(4 * data.length)
  for (const [i, compression] of data.entries()) {
    if (Number.isNaN(compression)) continue
    const position = (Math.min(compression, MAX_COMPRESSION) / MAX_COMPRESSION) * (COLOUR_SCALE.length - 1)
    const first = Math.min(Math.floor(position), COLOUR_SCALE.length - 2)
    for (let k = 0; k < 3; k++) {
      const [from, to] = [COLOUR_SCALE[first][k], COLOUR_SCALE[first + 1][k]]
      pixels[4 * i + k] = Math.round(from + (position - first) * (to - from))
    }
    pixels[4 * i + 3] = 255
  }
  return pixels
}
