import type { AutoWrinkles } from 'furrow/author'
import { autoDrivers, halfSide, strokesOf } from 'furrow/internal'
import { encodePng } from '../images/encode.ts'
import { encodeAreaImages } from './area-images.ts'
import type { PackedArea, PackedWrinkles } from './embed.ts'
import { encodeLayer, type LayerMaps } from './encode-layer.ts'
import { AREAS_PER_SLICE, encodeAreaArray, encodeMapArrays } from './ktx2-images.ts'

/** Three areas per image. The alpha channel stays free, because image tools drop colours where alpha is 0. */
const AREAS_PER_IMAGE = 3

/**
 * Encodes automatic wrinkles for a glTF file.
 *
 * @param ktx2 whether maps and areas become KTX 2 arrays. Heights stay PNG.
 */
export async function packAuto(wrinkles: AutoWrinkles, ktx2: boolean, who: string): Promise<PackedWrinkles> {
  const { layers, areas, jointAreas, blood, bulges, furrows } = wrinkles
  const maps = await Promise.all(
    layers.map(async (layer, i): Promise<LayerMaps> => {
      // Fine furrows are too shallow to move the surface, so their layer has no heights.
      const isFlat = layer.name === furrows?.furrows.layer
      const maps = await encodeLayer({ ...layer, blood: halfSide(blood.maps[i]) }, !isFlat, true)
      return { ...maps, bloodAmplitude: blood.amplitude }
    }),
  )
  const allAreas = [...areas, ...jointAreas, ...blood.areas, ...bulges, ...(furrows?.areas ?? [])]
  const weights = allAreas.map((area) => area.weights)
  const images = await (ktx2
    ? encodeAreaArray(weights, who)
    : encodeAreaImages(weights, AREAS_PER_IMAGE, encodePng))
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
