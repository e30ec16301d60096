import type { ImageArray } from '../image-array.ts'
import type { GrayImage } from '../types.ts'

/**
 * Packs the single-channel maps of each layer, such as occlusion and blood, into the channels of one slice per layer. There are two to four
 * maps per layer. Three maps occupy four channels, because WebGPU has no texture format with three channels.
 *
 * @param maps maps of each layer, in the order of the channels; copied. At least one layer must have a map. All maps must have the same
 *   size, which is not checked.
 * @param neutral bytes that fill missing maps, one per channel.
 */
export function packChannels(
  maps: readonly (readonly (GrayImage | undefined)[])[],
  neutral: readonly number[],
): ImageArray {
  const { width, height } = maps.flat().find((image) => image)!
  const texels = width * height
  const channels = neutral.length === 2 ? 2 : 4
  const data = new Uint8Array(channels * texels * maps.length)
  for (const [slice, ofLayer] of maps.entries()) {
    const start = channels * texels * slice
    for (const [channel, byte] of neutral.entries()) {
      const map = ofLayer[channel]?.data
      for (let i = 0; i < texels; i++) data[start + channels * i + channel] = map ? map[i] : byte
    }
  }
  return { width, height, depth: maps.length, channels, data }
}
