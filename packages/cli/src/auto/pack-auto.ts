import type { GrayImage } from 'furrow'
import { type AutoWrinkles, type RgbaImage, strokesOf } from 'furrow/author'
import { encodePng, encodeRgbaNormalMap } from '../images/encode.ts'
import { encodeAreaImages } from '../wrinkles/area-images.ts'
import type { CheckedImage } from '../wrinkles/checked-image.ts'
import type { LayerImages, PackedArea, PackedWrinkles } from '../wrinkles/embed.ts'
import { AREAS_PER_SLICE, encodeAreaArray, encodeMapArrays } from '../wrinkles/ktx2-images.ts'

/** Without alpha, since image tools drop colours where it is 0. */
const AREAS_PER_IMAGE = 3

/** A map of a layer as PNG, with its size. */
type LayerMaps = LayerImages & { normal: CheckedImage }

/**
 * Encodes the maps and areas of automatic wrinkles for a file, with the strokes that their lines are. Occlusion and heights have half the side of the normals: only these show how
 * steep a crease is.
 *
 * @param ktx2 whether maps and areas become KTX 2 arrays; these have no heights, which no renderer of Furrow reads.
 */
export async function packAuto(wrinkles: AutoWrinkles, ktx2: boolean, who: string): Promise<PackedWrinkles> {
  const { layers, areas, expressions } = wrinkles
  const maps = await Promise.all(
    layers.map(async ({ name, normal, relief, occlusion }): Promise<LayerMaps> => {
      const layer: LayerMaps = {
        name,
        kind: 'detail',
        normal: await normalImage(`${name} normal`, normal),
        occlusion: await grayImage(`${name} occlusion`, {
          ...occlusion,
          data: Float32Array.from(occlusion.data),
        }),
      }
      if (ktx2) return layer
      const heights = scaleHeights(relief.data)
      const height = await grayImage(`${name} height`, { ...relief, data: heights.levels })
      return { ...layer, height, heightAmplitude: heights.amplitude }
    }),
  )
  const weights = areas.map((area) => area.weights)
  const images = ktx2 ? await encodeAreaArray(weights, who) : encodeAreaImages(weights, AREAS_PER_IMAGE)
  const perImage = ktx2 ? AREAS_PER_SLICE : AREAS_PER_IMAGE
  const packed = areas.map(
    ({ name, layer }, i): PackedArea => ({
      name,
      layer,
      image: images[Math.floor(i / perImage)],
      channel: i % perImage,
    }),
  )
  return {
    layers: ktx2 ? await encodeMapArrays(maps, who) : maps,
    areas: packed,
    drivers: [...areas.map(({ driver }) => driver), ...expressions],
    strokes: strokesOf(wrinkles),
  }
}

async function normalImage(name: string, map: RgbaImage): Promise<CheckedImage> {
  const { width, height } = map
  return { name, mimeType: 'image/png', bytes: await encodeRgbaNormalMap(map), width, height }
}

/** Encodes a map of levels 0..255 with half its side: each texel is the mean of four. */
async function grayImage(
  name: string,
  { width, height, data }: Omit<GrayImage, 'data'> & { data: Float32Array },
): Promise<CheckedImage> {
  const half = { width: width / 2, height: height / 2 }
  const out = new Uint8Array(half.width * half.height)
  for (let y = 0; y < half.height; y++) {
    for (let x = 0; x < half.width; x++) {
      const i = 2 * y * width + 2 * x
      out[y * half.width + x] = Math.round(
        (data[i] + data[i + 1] + data[i + width] + data[i + width + 1]) / 4,
      )
    }
  }
  return { name, mimeType: 'image/png', bytes: await encodePng({ ...half, data: out, channels: 1 }), ...half }
}

/** Heights in millimetres as levels 0..255, 127.5 = 0 mm; `amplitude` is the height of white above black in metres. */
function scaleHeights(millimetres: Float32Array): { levels: Float32Array; amplitude: number } {
  let largest = 0.001
  for (let i = 0; i < millimetres.length; i++) largest = Math.max(largest, Math.abs(millimetres[i]))
  return {
    levels: millimetres.map((height) => 127.5 + (127.5 * height) / largest),
    amplitude: (2 * largest) / 1000,
  }
}
