import {
  type AutoWrinkles,
  autoDrivers,
  halfSide,
  heightLevels,
  type RgbaImage,
  strokesOf,
} from 'furrow/author'
import { encodePng, encodeRgbaNormalMap } from '../images/encode.ts'
import { encodeAreaImages } from '../wrinkles/area-images.ts'
import { withBlood } from '../wrinkles/blood-image.ts'
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
 * @param ktx2 whether maps and areas become KTX 2 arrays. Heights remain PNG.
 */
export async function packAuto(wrinkles: AutoWrinkles, ktx2: boolean, who: string): Promise<PackedWrinkles> {
  const { layers, areas, blood, furrows } = wrinkles
  const maps = await Promise.all(
    layers.map(async ({ name, normal, relief, occlusion }, i): Promise<LayerMaps> => {
      const maps = {
        name,
        normal: await normalImage(`${name} normal`, normal),
        occlusion: await grayImage(`${name} occlusion`, occlusion),
        blood: await grayImage(`${name} blood`, blood.maps[i]),
      }
      const layer: LayerMaps = {
        ...(await withBlood(maps, who)),
        kind: 'detail',
        bloodAmplitude: blood.amplitude,
      }
      // Fine furrows are too shallow to move the surface.
      if (name === furrows?.furrows.layer) return layer
      const heights = heightLevels(relief.data)
      const height = await grayImage(`${name} height`, { ...relief, data: heights.levels })
      return { ...layer, height, heightAmplitude: heights.amplitude }
    }),
  )
  const allAreas = [...areas, ...blood.areas, ...(furrows?.areas ?? [])]
  const weights = allAreas.map((area) => area.weights)
  const images = ktx2 ? await encodeAreaArray(weights, who) : encodeAreaImages(weights, AREAS_PER_IMAGE)
  const perImage = ktx2 ? AREAS_PER_SLICE : AREAS_PER_IMAGE
  const packed = allAreas.map(
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
    drivers: autoDrivers(wrinkles),
    strokes: strokesOf(wrinkles),
  }
}

async function normalImage(name: string, map: RgbaImage): Promise<CheckedImage> {
  const { width, height } = map
  return { name, mimeType: 'image/png', bytes: await encodeRgbaNormalMap(map), width, height }
}

/** Encodes a map of levels 0..255 with half its side. */
async function grayImage(name: string, map: Parameters<typeof halfSide>[0]): Promise<CheckedImage> {
  const { width, height, data } = halfSide(map)
  return {
    name,
    mimeType: 'image/png',
    bytes: await encodePng({ width, height, data, channels: 1 }),
    width,
    height,
  }
}
