import { FurrowError } from 'furrow'
import { decodeImage } from '#images'
import { channelOf } from '../images/pixels.ts'
import { encodePortablePng } from '../images/png.ts'
import { scaleImage } from '../images/scale.ts'
import type { MapName } from '../wrinkles/map-slots.ts'
import { joinChannels } from '../wrinkles/shared-image.ts'
import type { CheckedImage } from './checked-image.ts'

/**
 * Writes a layer's blood map into the blue channel of its occlusion image, scaled to that size. Roughness stays in green if it shares
 * the image with occlusion. Channels without a map are white.
 *
 * @returns the layer with its maps in the new image.
 * @throws FurrowError if blood and occlusion differ in size and the occlusion is not square.
 */
export async function withBlood<L extends { name: string } & Partial<Record<MapName, CheckedImage>>>(
  layer: L,
  who: string,
): Promise<L> {
  const { name, blood, occlusion, roughness } = layer
  if (!blood || blood === occlusion) return layer
  const { width, height } = occlusion ?? blood
  const isScaled = width !== blood.width || height !== blood.height
  if (isScaled && width !== height) {
    throw new FurrowError({
      who,
      problem: `the blood map of layer "${name}" differs in size from its occlusion`,
      value: `${blood.width} x ${blood.height}`,
      limit: `${width} x ${height}, because both share an image`,
      remedy: 'scale both to one size',
    })
  }
  const read = async (image: CheckedImage | undefined, channel: number) => {
    if (!image) return undefined
    const pixels = await decodeImage(image.bytes, image.name, who)
    return channelOf(image === blood && isScaled ? scaleImage(pixels, width) : pixels, channel)
  }
  const isShared = roughness !== undefined && roughness === occlusion
  const channels = [
    await read(occlusion, 0),
    isShared ? await read(roughness, 1) : undefined,
    await read(blood, 2),
  ]
  const bytes = encodePortablePng(joinChannels(channels, width, height))
  const image = { ...(occlusion ?? blood), mimeType: 'image/png', bytes }
  return {
    ...layer,
    blood: image,
    ...(occlusion && { occlusion: image }),
    ...(isShared && { roughness: image }),
  }
}
