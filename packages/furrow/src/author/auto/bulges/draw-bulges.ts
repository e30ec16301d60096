import type { GrayImage } from '../../../core/types.ts'
import type { AgeDriver } from '../../../drivers/age/definition.ts'
import { heightToNormal } from '../../normals/height-to-normal.ts'
import { drawStrokes } from '../../strokes/height.ts'
import { drawAreas } from '../raster/draw-areas.ts'
import type { AutoLayer, AutoMaps, MapSettings } from '../raster/draw-maps.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import { bulgeDriver } from './bulge-driver.ts'
import type { LaidBulge } from './lay-bulges.ts'

/** Distance in millimetres over which the area of a bulge fades out beyond its foot. */
const FEATHER = 3

/** Area of influence of skin that rises with age. */
export interface BulgeArea {
  name: string
  /** Index of the area's layer. */
  layer: number
  weights: GrayImage
  /** Driver that raises the skin, depending on the input `age`. */
  driver: AgeDriver
}

/**
 * Draws the layer with the bulges of a face, and their areas of influence. Bulges need a separate layer, because areas of lines would show
 * the bulges below them.
 *
 * @param drawn layers with wrinkle lines.
 * @param years age until the application sets the input `age`.
 */
export function drawBulges(
  { chart }: DetectedFace,
  bulges: readonly LaidBulge[],
  { layers, texels, areaTexels, metric }: AutoMaps,
  { frame, years }: Pick<MapSettings, 'frame'> & { years: number },
): { layers: AutoLayer[]; areas: BulgeArea[] } {
  const drawn = drawStrokes(
    bulges.flatMap(({ creases }) => creases),
    { texels, metric },
  )
  const normal = heightToNormal(drawn.heights, metric, frame)
  const strokes = bulges.flatMap(({ name, strokes }) => strokes.map((stroke) => ({ group: name, ...stroke })))
  const sources = bulges.map(({ reach, creases }) => ({ region: { reach, feather: FEATHER }, creases }))
  const areas = drawAreas(areaTexels, sources, chart).map((weights, i) => ({
    name: bulges[i].name,
    layer: layers.length,
    weights,
    driver: bulgeDriver(bulges[i].name, years),
  }))
  return { layers: [{ name: `auto${layers.length + 1}`, strokes, normal, ...drawn }], areas }
}
