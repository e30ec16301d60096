import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import sharp from 'sharp'
import { toSrgb } from './evaluate.ts'

/** Normals, and linear colours if the source has any, three numbers per texel. */
export interface Shaded {
  normals: Float64Array
  colours?: Float64Array
}

/** Direction to the light. */
const LIGHT = [-0.45, 0.55, 0.7]
const SKIN = [0.6, 0.36, 0.27]
const AMBIENT = 0.1
/** Differences are drawn so many times larger. */
export const GAIN = 16

/** Lights a square of skin. Returns sRGB bytes, three per texel. */
export function lit({ normals, colours }: Shaded): Uint8Array {
  const length = Math.hypot(...LIGHT)
  return Uint8Array.from(normals, (_, k) => {
    const first = k - (k % 3)
    const cosine = LIGHT.reduce((sum, value, i) => sum + value * normals[first + i]!, 0) / length
    const colour = colours ? colours[k]! : SKIN[k % 3]!
    return Math.min(255, Math.round(255 * toSrgb(colour * (AMBIENT + (1 - AMBIENT) * Math.max(0, cosine)))))
  })
}

/**
 * Writes a sheet with a column per pose: the source's formula, Furrow's result, and their difference.
 *
 * @param folder folder of the picture. Nothing is written if it is undefined.
 */
export async function writeSheet(
  folder: string | undefined,
  name: string,
  size: number,
  pairs: readonly { source: Shaded; shown: Shaded }[],
): Promise<void> {
  if (folder === undefined) return
  const gap = 4
  const tiles = pairs.flatMap(({ source, shown }, column) => {
    const [theirs, own] = [lit(source), lit(shown)]
    const difference = theirs.map((byte, i) => Math.min(255, GAIN * Math.abs(byte - own[i]!)))
    return [theirs, own, difference].map((data, row) => ({
      input: Buffer.from(data),
      raw: { width: size, height: size, channels: 3 as const },
      left: column * (size + gap),
      top: row * (size + gap),
    }))
  })
  const width = pairs.length * (size + gap) - gap
  const height = 3 * (size + gap) - gap
  const sheet = sharp({ create: { width, height, channels: 3, background: 'white' } }).composite(tiles)
  mkdirSync(folder, { recursive: true })
  writeFileSync(join(folder, `${name}.jpg`), await sheet.jpeg({ quality: 88 }).toBuffer())
}
