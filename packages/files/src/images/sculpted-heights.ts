import { decode, encode } from 'fast-png'
import { FurrowError } from 'furrow'
import type { HeightMap } from 'furrow/author'
import { HEIGHT_STEPS_PER_MM } from 'furrow/internal'
import { measureImage } from '#images'
import { HEIGHT_ZERO, heightSteps } from './height-steps.ts'
import { withImageErrors } from './image-errors.ts'

/** Encodes sculpted heights as 16-bit gray PNG, like `encodeHeight`. The bytes are equal in Node and in all browsers. */
export function encodeSculpted({ width, height, data }: HeightMap): Uint8Array {
  return encode({ width, height, channels: 1, data: heightSteps(data), depth: 16 }, { zlib: { level: 9 } })
}

/**
 * Decodes sculpted heights. Returns millimetres.
 *
 * @param path path of the image, for errors.
 * @throws FurrowError if the image is not a gray PNG with 16 bits, or is damaged.
 */
export async function decodeSculpted(bytes: Uint8Array, path: string, who: string): Promise<HeightMap> {
  await measureImage(bytes, path, who, ['image/png'])
  const { width, height, channels, depth, data } = await withImageErrors(path, who, async () => decode(bytes))
  if (channels !== 1 || depth !== 16) {
    throw new FurrowError({
      who,
      problem: `the sculpted heights ${path} have an unsupported format`,
      value: `${channels} channels of ${depth} bits`,
      limit: '1 channel of 16 bits',
      remedy: 'save them as 16-bit gray PNG',
    })
  }
  const heights = Float32Array.from(data, (step) => (step - HEIGHT_ZERO) / HEIGHT_STEPS_PER_MM)
  return { width, height, data: heights }
}
