import type { GrayImage } from 'furrow'
import { CHANNEL, type WrinkleMapsLayer } from 'furrow/internal'
import type { Glb } from '../gltf/glb.ts'
import { pixelsOf } from '../gltf/texture-pixels.ts'
import { channelOf, type Pixels } from '../images/pixels.ts'
import type { MapName } from './map-slots.ts'

/** Combines up to three maps of equal size as red, green and blue. A missing map is white. */
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
 * Extracts occlusion, blood or onset from the image that they share.
 *
 * @returns undefined if the map has an image to itself.
 */
export async function partOfImage(
  glb: Glb,
  layer: WrinkleMapsLayer,
  map: MapName,
  who: string,
): Promise<GrayImage | undefined> {
  if (map !== 'occlusion' && map !== 'blood' && map !== 'onset') return undefined
  const own = layer[`${map}Texture`]
  const isShared = layer.bloodTexture !== undefined || layer.onsetTexture !== undefined
  if (!own || !isShared) return undefined
  return channelOf(await pixelsOf(glb, own, who), CHANNEL[map])
}
