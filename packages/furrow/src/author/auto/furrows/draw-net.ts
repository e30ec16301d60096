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

/** Area of influence that shows fine furrows. */
export interface FurrowArea {
  name: string
  /** Index of the area's layer. */
  layer: number
  weights: GrayImage
  /** Driver that deepens the furrows where skin is compressed, and smooths them where skin is stretched. */
  driver: MorphDriver
}

/** Pattern of fine furrows of a face. The last layer contains only this pattern. */
export interface AutoFurrows {
  /** Parameters of the pattern, as in a strokes document. `addFurrows` draws the pattern from them and the strokes of all layers. */
  furrows: Furrows
  areas: FurrowArea[]
}

/**
 * Draws the layer with the fine furrows of a face, and the areas of influence that show them.
 *
 * @param drawn layers with wrinkle lines. The furrows follow these lines.
 */
export function drawNet(
  prepared: PreparedSkin & { face: DetectedFace },
  { regions, furrows }: PlannedNet,
  { layers, areaTexels }: Pick<AutoMaps, 'layers' | 'areaTexels'>,
  { size, frame }: MapSettings,
): { layer: AutoLayer; net: AutoFurrows } {
  // The pattern depends on the coordinate system. Use the mesh's coordinates rather than the face's, because whoever draws the strokes document
  // later has only the mesh, and must get the same pattern.
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

/** Draws the weights of the areas. They are 0 on hidden skin, such as inside the mouth. */
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
