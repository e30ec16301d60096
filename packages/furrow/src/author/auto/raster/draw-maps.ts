import type { GrayImage, RgbaImage } from '../../../core/types.ts'
import { MIPMAP_MARGIN } from '../../border.ts'
import { surfaceMetric } from '../../metric.ts'
import { type TangentFrame, turnedNormals } from '../../normals/height-to-normal.ts'
import { SkinTexels } from '../../skin/skin-texels.ts'
import type { SkinSurface } from '../../skin/surface.ts'
import type { Stroke } from '../../strokes/document.ts'
import { drawStrokes, type HeightMap } from '../../strokes/height.ts'
import type { FittedRegion } from '../fit/fit-driver.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { drawAreas } from './draw-areas.ts'
import { FacetFrames } from './facet-frames.ts'

/** Maps of one layer. */
export interface AutoLayer {
  name: string
  /** Lines of the layer, each in the group named after its area: `strokesToHeight` draws them as `heights`. */
  strokes: Stroke[]
  /** Normal map of kind `detail`: wrinkles on flat skin. */
  normal: RgbaImage
  heights: HeightMap
  /** 255 = open to the light. */
  occlusion: GrayImage
}

export interface MapSettings {
  /** Side of the layers' maps in texels. */
  size: number
  /** Side of the areas in texels. */
  areaSize: number
  /** Tangent frame of the normal maps. */
  frame: TangentFrame
}

/** Drawn maps, with the positions of their texels on the skin. */
export interface AutoMaps {
  layers: AutoLayer[]
  /** Weights of each region's area. */
  weights: GrayImage[]
  /** Texels of the layers' maps and of the areas. */
  texels: SkinTexels
  areaTexels: SkinTexels
}

/**
 * Draws the maps of all layers and areas.
 *
 * @param layerOf layer of each region.
 * @param report called with the fraction done.
 * @returns undefined if there are no regions.
 */
export function drawMaps(
  prepared: PreparedSkin,
  regions: readonly FittedRegion[],
  layerOf: readonly number[],
  { size, areaSize, frame }: MapSettings,
  report: (fraction: number) => void,
): AutoMaps | undefined {
  // Return early: locating the texels costs more than all previous steps.
  if (regions.length === 0) return undefined
  const { skin, surface, face, isDrawn } = prepared
  const texels = new SkinTexels(skin, surface, size, size, isDrawn, MIPMAP_MARGIN)
  const areaTexels = new SkinTexels(skin, surface, areaSize, areaSize, isDrawn)
  const metric = surfaceMetric({ ...skin, positions: inMetres(surface) }, size)
  const layers: AutoLayer[] = []
  const weights: GrayImage[] = []
  const barycentrics = new Float64Array(3)
  const layerCount = Math.max(...layerOf) + 1
  /** Reports one of a layer's four parts: creases, frames, normals, areas. */
  const reportPart = (layer: number, part: number) => report((layer + part / 4) / layerCount)
  for (let layer = 0; layer < layerCount; layer++) {
    reportPart(layer, 0)
    const members = [...regions.keys()].filter((i) => layerOf[i] === layer)
    const own = members.map((i) => regions[i])
    const strokes = strokesOf(own)
    const drawn = drawStrokes([...new Set(own.map(({ creases }) => creases))].flat(), { texels, metric })
    reportPart(layer, 1)
    const frames = frame === 'derivative' ? new FacetFrames(prepared, own) : undefined
    reportPart(layer, 2)
    const normal = turnedNormals(drawn.heights, metric, frame, (texel, slope) =>
      frames?.turn(texels.locate(texel, barycentrics), barycentrics, slope),
    )
    layers.push({ name: `auto${layer + 1}`, strokes, normal, ...drawn })
    reportPart(layer, 3)
    for (const [k, image] of drawAreas(areaTexels, own, face?.chart).entries()) weights[members[k]] = image
  }
  return { layers, weights, texels, areaTexels }
}

/** Returns the strokes of a layer's regions. Lines shared by left and right are in a group without a side. */
function strokesOf(regions: readonly FittedRegion[]): Stroke[] {
  const groups = new Map<readonly Stroke[], string>()
  for (const { region, strokes } of regions) {
    groups.set(strokes, groups.has(strokes) ? region.name.replace(/(Left|Right)$/, '') : region.name)
  }
  return [...groups].flatMap(([strokes, group]) => strokes.map((stroke) => ({ group, ...stroke })))
}

/** Returns the positions of the skin's vertices in the surface's scale, converted to metres. */
function inMetres({ pointOf, points }: SkinSurface): Float64Array {
  const out = new Float64Array(3 * pointOf.length)
  for (const [vertex, point] of pointOf.entries()) {
    for (let k = 0; k < 3; k++) out[3 * vertex + k] = points[3 * point + k] / 1000
  }
  return out
}
