import { GLTF_IMAGES, type ImageHeader } from './check-image.ts'
import { withImageErrors } from './image-errors.ts'
import { openImage } from './open-image.ts'
import type { DecodedImage } from './pixels.ts'

/** Node implementation with libvips, which uses a tenth of the memory; see codec.browser.ts. */
export { encodeMap } from './encode.ts'

/** Node implementation with libvips; see codec.browser.ts. */
export async function measureImage(
  bytes: Uint8Array,
  name: string,
  who: string,
  types = GLTF_IMAGES,
): Promise<ImageHeader> {
  return openImage(bytes, name, who, types)
}

/** Node implementation with libvips; see codec.browser.ts. */
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

/** Node implementation with libvips, which decodes in parts; see codec.browser.ts. */
export async function checkDecodable(bytes: Uint8Array, name: string, who: string): Promise<void> {
  const { image, width, height } = await openImage(bytes, name, who)
  // Decoding the last row decodes all rows above, and is ten times faster than computing statistics.
  const lastRow = image.extract({ left: 0, top: height - 1, width, height: 1 })
  await withImageErrors(name, who, () => lastRow.raw().toBuffer())
}
