import { FurrowError } from 'furrow'
import { CHANNEL } from 'furrow/internal'
import { decodeImage } from '#images'
import { channelOf } from '../images/pixels.ts'
import { encodePortablePng } from '../images/png.ts'
import { scaleImage } from '../images/scale.ts'
import type { MapName } from '../wrinkles/map-slots.ts'
import { joinChannels } from '../wrinkles/shared-image.ts'
import type { CheckedImage } from './checked-image.ts'

/**
 * Writes the blood map of a layer into the blue channel of its occlusion image, and the onset map (activation at which
 * wrinkles begin to show) into the green channel. Scales both maps to the size of the occlusion map. If there is no
 * occlusion map, scales the onset map to the size of the blood map. Channels without a map are white.
 *
 * Roughness also uses the green channel. If roughness shares its image with occlusion, it moves to the new image,
 * unless there is an onset map. In that case roughness keeps its image.
 *
 * @returns the layer with its maps in the new image.
 * @throws FurrowError if a map has to be scaled to a size that is not square.
 */
export async function shareImage<L extends { name: string } & Partial<Record<MapName, CheckedImage>>>(
  layer: L,
  who: string,
): Promise<L> {
  const { occlusion, blood, onset, roughness } = layer
  const isShared = roughness !== undefined && roughness === occlusion
  const isJoined = (!blood || blood === occlusion) && (!onset || onset === (occlusion ?? blood))
  if ((!blood && !onset) || (isJoined && !(onset && isShared))) return layer
  const { width, height } = (occlusion ?? blood ?? onset)!
  const read = async (map: keyof typeof CHANNEL) => {
    const image = layer[map]
    if (!image) return undefined
    const isScaled = image.width !== width || image.height !== height
    if (isScaled && width !== height) throw sizeMismatch(layer.name, map, image, { width, height }, who)
    const pixels = await decodeImage(image.bytes, image.name, who)
    return channelOf(isScaled ? scaleImage(pixels, width) : pixels, CHANNEL[map])
  }
  const green = onset ? 'onset' : 'roughness'
  const channels = [
    await read('occlusion'),
    onset || isShared ? await read(green) : undefined,
    await read('blood'),
  ]
  const bytes = encodePortablePng(joinChannels(channels, width, height))
  const image = { ...(occlusion ?? blood ?? onset)!, mimeType: 'image/png', width, height, bytes }
  return {
    ...layer,
    ...(occlusion && { occlusion: image }),
    ...(blood && { blood: image }),
    ...(onset && { onset: image }),
    ...(isShared && !onset && { roughness: image }),
  }
}

function sizeMismatch(
  layer: string,
  map: MapName,
  { width, height }: CheckedImage,
  limit: { width: number; height: number },
  who: string,
): FurrowError {
  return new FurrowError({
    who,
    problem: `the ${map} map of layer "${layer}" differs in size from the map that shares its image`,
    value: `${width} x ${height}`,
    limit: `${limit.width} x ${limit.height}`,
    remedy: 'scale both to one size',
  })
}
