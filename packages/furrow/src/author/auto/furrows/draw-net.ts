import type { GrayImage } from '../../../core/types.ts'
import type { MorphDriver } from '../../../drivers/morph/definition.ts'
import { addFurrows } from '../../furrows/furrows.ts'
import type { Furrows } from '../../furrows/read-furrows.ts'
import { heightToNormal } from '../../normals/height-to-normal.ts'
import { skinCanvas } from '../../skin/canvas.ts'
import type { SkinTexels } from '../../skin/skin-texels.ts'
import { flatSkin } from '../../strokes/height.ts'
import type { AutoLayer, AutoMaps, MapSettings } from '../raster/draw-maps.ts'
import { visibility } from '../raster/visibility.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { netDrivers } from './net-drivers.ts'
import { netWeights } from './net-weights.ts'
import { FURROW_LAYER, type PlannedNet } from './plan-net.ts'

export interface FurrowArea {
  name: string
  /** Index of its layer. */
  layer: number
  weights: GrayImage
  /** Deepens the furrows where skin is squeezed, and smooths them where it is stretched. */
  driver: MorphDriver
}

/** Net of fine furrows, on the last layer. */
export interface AutoFurrows {
  /** Net as in a strokes document: with the strokes of all layers, `addFurrows` draws the layer's `heights`. */
  furrows: Furrows
  areas: FurrowArea[]
}

/**
 * Draws the net of a face and its areas.
 *
 * @param drawn layers of lines that the net follows; its own layer comes last.
 */
export function drawNet(
  prepared: PreparedSkin & { face: DetectedFace },
  { regions, furrows }: PlannedNet,
  { layers, areaTexels }: Pick<AutoMaps, 'layers' | 'areaTexels'>,
  { size, frame }: MapSettings,
): { layer: AutoLayer; net: AutoFurrows } {
  // Use mesh coordinates, like a document is drawn, because the net depends on them.
  const canvas = skinCanvas(prepared.skin, size, size, prepared.scale)
  const { heights, occlusion } = flatSkin(size, size)
  addFurrows(
    heights,
    canvas,
    furrows,
    layers.flatMap(({ strokes }) => strokes),
  )
  const normal = heightToNormal(heights, canvas.metric, frame)
  const weights = drawWeights(prepared.face, regions, areaTexels)
  const areas = netDrivers(prepared.face, regions).map((driver, i) => ({
    name: driver.area,
    layer: layers.length,
    weights: weights[i],
    driver,
  }))
  return { layer: { name: FURROW_LAYER, strokes: [], normal, heights, occlusion }, net: { furrows, areas } }
}

/** Draws the weights of the areas, 0 on hidden skin. */
function drawWeights(
  { chart }: DetectedFace,
  regions: PlannedNet['regions'],
  texels: SkinTexels,
): GrayImage[] {
  const { width, height } = texels
  const images = regions.map(() => new Uint8Array(width * height))
  const weights = new Float64Array(regions.length)
  texels.visitNear(
    () => true,
    (texel, [x, y, z], normal) => {
      netWeights(regions, x, y, z, weights)
      if (weights.every((weight) => weight === 0)) return
      const visible = visibility(chart, x, y, z, normal)
      for (const [i, data] of images.entries()) data[texel] = Math.round(255 * weights[i] * visible)
    },
  )
  return images.map((data) => ({ width, height, data }))
}
