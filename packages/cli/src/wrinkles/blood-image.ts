import { FurrowError, type GrayImage, type WrinkleMapsLayer } from 'furrow'
import { decodeImage } from '#platform/images'
import type { Glb } from '../gltf/glb-file.ts'
import { pixelsOf } from '../gltf/texture-pixels.ts'
import { channelOf, type Pixels } from '../images/pixels.ts'
import { encodePortablePng } from '../images/png.ts'
import { scaleImage } from '../images/scale.ts'
import type { MapName } from './map-slots.ts'
import type { CheckedImage } from './pack/checked-image.ts'

/** Channels of the maps that share an image, as glTF has them; roughness is the second. */
const CHANNELS: Partial<Record<MapName, number>> = { occlusion: 0, blood: 2 }

/**
 * Puts blood into the blue channel of a layer's occlusion, at its size. Red is white where there is none, and green where roughness is elsewhere.
 *
 * @param layer its maps; where the roughness is in the image of the occlusion, it stays there.
 * @returns the maps with the images that hold blood.
 * @throws FurrowError when the two differ in size and the occlusion is not square.
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
      what: `the blood map of layer "${name}" differs in size from its occlusion`,
      value: `${blood.width} x ${blood.height}`,
      limit: `${width} x ${height}: they share an image`,
      remedy: 'scale them to one size',
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

/** Maps of one size as red, green and blue; white where there is none. */
export function joinChannels(
  maps: readonly (GrayImage | undefined)[],
  width: number,
  height: number,
): Pixels {
  const data = new Uint8Array(3 * width * height).fill(255)
  for (const [channel, map] of maps.entries()) {
    if (map) for (let i = 0; i < map.data.length; i++) data[3 * i + channel] = map.data[i]
  }
  return { width, height, channels: 3, data }
}

/**
 * A map that shares its image with blood, on its own.
 *
 * @returns undefined for maps that do not.
 */
export async function partOfImage(
  glb: Glb,
  layer: WrinkleMapsLayer,
  map: MapName,
  who: string,
): Promise<GrayImage | undefined> {
  const channel = CHANNELS[map]
  const { bloodTexture } = layer
  const isThere = map === 'blood' || layer.occlusionTexture !== undefined
  if (channel === undefined || !bloodTexture || !isThere) return undefined
  return channelOf(await pixelsOf(glb, bloodTexture, who), channel)
}
