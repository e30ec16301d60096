import { GLTF_IMAGES, type ImageHeader } from './check-image.ts'
import { withImageErrors } from './image-errors.ts'
import { openImage } from './open-image.ts'
import type { DecodedImage } from './pixels.ts'

/** Counterpart of `codec.browser.ts` for Node. libvips encodes with a tenth of the memory that fast-png needs. */
export { encodeMap } from './encode.ts'

/** Reads the format and size of an image with libvips. Documented in `codec.browser.ts`. */
export async function measureImage(
  bytes: Uint8Array,
  name: string,
  who: string,
  types = GLTF_IMAGES,
): Promise<ImageHeader> {
  return openImage(bytes, name, who, types)
}

/** Decodes an image with libvips. Documented in `codec.browser.ts`. */
export async function decodeImage(
  bytes: Uint8Array,
  name: string,
  who: string,
  types = GLTF_IMAGES,
): Promise<DecodedImage> {
  const { image, type } = await openImage(bytes, name, who, types)
  const raw = image.toColourspace('srgb').raw()
  const { data, info } = await withImageErrors(name, who, () => raw.toBuffer({ resolveWithObject: true }))
  return { type, width: info.width, height: info.height, channels: info.channels, data }
}

/** Decodes a whole image with libvips to check it, strip by strip. Throws like `decodeImage`. */
export async function checkDecodable(bytes: Uint8Array, name: string, who: string): Promise<void> {
  const { image, width, height } = await openImage(bytes, name, who)
  // Decoding the last row decodes all rows above it, and is ten times faster than `image.stats()`.
  const lastRow = image.extract({ left: 0, top: height - 1, width, height: 1 })
  await withImageErrors(name, who, () => lastRow.raw().toBuffer())
}
