import type { GrayImage } from 'furrow'
import type { AutoWrinkles, RgbaImage } from 'furrow/author'
import { encodePng, encodeRgbaNormalMap } from '../images/encode.ts'
import { encodeAreaImages } from '../wrinkles/area-images.ts'
import type { FileImage, LayerImages, PackedArea, PackedWrinkles } from '../wrinkles/embed.ts'

/** Without alpha, since image tools drop colours where it is 0. */
const AREAS_PER_IMAGE = 3

/** Encodes the maps and areas of automatic wrinkles for a file. */
export async function packAuto({ layers, areas, expressions }: AutoWrinkles): Promise<PackedWrinkles> {
  const maps = await Promise.all(
    layers.map(async ({ name, normal, relief, occlusion }): Promise<LayerImages> => {
      const heights = quantiseHeights(relief.data)
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
  const images = await encodeAreaImages(
    areas.map(({ weights }) => weights),
    AREAS_PER_IMAGE,
  )
  const packed = areas.map(
    ({ name, layer }, i): PackedArea => ({
      name,
      layer,
      image: images[Math.floor(i / AREAS_PER_IMAGE)],
      channel: i % AREAS_PER_IMAGE,
    }),
  )
  return { layers: maps, areas: packed, drivers: [...areas.map(({ driver }) => driver), ...expressions] }
}

async function normalImage(name: string, map: RgbaImage): Promise<FileImage> {
  return { name, mimeType: 'image/png', bytes: await encodeRgbaNormalMap(map) }
}

async function grayImage(name: string, image: GrayImage): Promise<FileImage> {
  return { name, mimeType: 'image/png', bytes: await encodePng({ ...image, channels: 1 }) }
}

/** Heights in millimetres as bytes, 127.5 = 0 mm; `amplitude` is the height of white above black in metres. */
function quantiseHeights(millimetres: Float32Array): { data: Uint8Array; amplitude: number } {
  let largest = 0.001
  for (let i = 0; i < millimetres.length; i++) largest = Math.max(largest, Math.abs(millimetres[i]))
  // Loops: with millions of texels `from` and `reduce` take a second, and ten times the memory.
  const data = new Uint8Array(millimetres.length)
  for (let i = 0; i < data.length; i++) data[i] = Math.round(127.5 + (127.5 * millimetres[i]) / largest)
  return { data, amplitude: (2 * largest) / 1000 }
}
