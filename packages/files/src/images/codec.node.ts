import { GLTF_IMAGES, type ImageHeader } from './check-image.ts'
import { withImageErrors } from './image-errors.ts'
import { openImage } from './open-image.ts'
import type { DecodedImage } from './pixels.ts'

/** By libvips, which takes a tenth of the memory; see the function of this name for browsers. */
export { encodeMap } from './encode.ts'

/** By libvips; see the function of this name for browsers. */
export async function measureImage(
  bytes: Uint8Array,
  name: string,
  who: string,
  types = GLTF_IMAGES,
): Promise<ImageHeader> {
  return openImage(bytes, name, who, types)
}

/** By libvips; see the function of this name for browsers. */
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

/** By libvips, a part of the image at a time; see the function of this name for browsers. */
export async function checkWhole(bytes: Uint8Array, name: string, who: string): Promise<void> {
  const { image, width, height } = await openImage(bytes, name, who)
  // For it all rows above are decoded too. To compute statistics of all takes ten times as long.
  const lastRow = image.extract({ left: 0, top: height - 1, width, height: 1 })
  await withImageErrors(name, who, () => lastRow.raw().toBuffer())
}
