import type { GrayImage } from 'furrow'
import type { WrinkleMapsLayer } from 'furrow/internal'
import type { Glb } from '../gltf/glb.ts'
import { pixelsOf } from '../gltf/texture-pixels.ts'
import { channelOf, type Pixels } from '../images/pixels.ts'
import type { MapName } from './map-slots.ts'

/** Channels of maps that share an image. glTF uses 1 for roughness. */
const CHANNELS: Partial<Record<MapName, number>> = { occlusion: 0, blood: 2 }

/** Combines up to three maps of one size as red, green and blue. Missing maps are white. */
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
 * Extracts a map that shares its image with blood.
 *
 * @returns undefined if the map has its own image.
 */
export async function partOfImage(
  glb: Glb,
  layer: WrinkleMapsLayer,
  map: MapName,
  who: string,
): Promise<GrayImage | undefined> {
  const channel = CHANNELS[map]
  const { bloodTexture } = layer
  const isPresent = map === 'blood' || layer.occlusionTexture !== undefined
  if (channel === undefined || !bloodTexture || !isPresent) return undefined
  return channelOf(await pixelsOf(glb, bloodTexture, who), channel)
}
