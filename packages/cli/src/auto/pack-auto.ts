import type { GrayImage } from 'furrow'
import type { AutoWrinkles, RgbaImage } from 'furrow/author'
import { encodeNormal } from '../images.ts'
import type { AreaPlace, FileImage, LayerImages, PackedWrinkles } from '../wrinkles/embed.ts'
import { encodePixels, shareImages } from '../wrinkles/map-images.ts'

/** Areas to an image: R, G and B, which every image tool leaves alone. */
const SHARE = 3

/** Encodes the maps of automatic wrinkles as a file holds them. */
export async function packAuto({ layers, areas, expressions }: AutoWrinkles): Promise<PackedWrinkles> {
  const maps = await Promise.all(
    layers.map(async ({ name, normal, relief, occlusion }): Promise<LayerImages> => {
      const heights = heightImage(relief.data)
      return {
        name,
        kind: 'detail',
        normal: await normalImage(`${name} normal`, normal),
        occlusion: await grayImage(`${name} occlusion`, occlusion),
        height: await grayImage(`${name} height`, { ...relief, data: heights.data }),
        heightAmplitude: heights.amplitude,
      }
    }),
  )
  const images = await shareImages(
    areas.map(({ weights }) => weights),
    SHARE,
  )
  const places = areas.map(
    ({ name, layer }, i): AreaPlace => ({
      name,
      layer,
      image: images[Math.floor(i / SHARE)],
      channel: i % SHARE,
    }),
  )
  return { layers: maps, areas: places, drivers: [...areas.map(({ driver }) => driver), ...expressions] }
}

async function normalImage(name: string, map: RgbaImage): Promise<FileImage> {
  return { name, mimeType: 'image/png', bytes: await encodeNormal(map) }
}

async function grayImage(name: string, image: GrayImage): Promise<FileImage> {
  return { name, mimeType: 'image/png', bytes: await encodePixels({ ...image, channels: 1 }) }
}

/** Millimetres as bytes, 128 at the surface; the amplitude is metres from black to white. */
function heightImage(millimetres: Float32Array): { data: Uint8Array; amplitude: number } {
  let farthest = 0.001
  for (let i = 0; i < millimetres.length; i++) farthest = Math.max(farthest, Math.abs(millimetres[i]))
  // In loops: `from` and `reduce` take a second for the millions of texels, and ten times the memory.
  const data = new Uint8Array(millimetres.length)
  for (let i = 0; i < data.length; i++) data[i] = Math.round(127.5 + (127.5 * millimetres[i]) / farthest)
  return { data, amplitude: (2 * farthest) / 1000 }
}
