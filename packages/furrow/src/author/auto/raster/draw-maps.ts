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
  /** Lines of the layer. Each stroke's `group` is the name of its area. Drawing them with `strokesToHeight` gives `heights`. */
  strokes: Stroke[]
  /** Normal map of wrinkles on otherwise flat skin, for a layer of kind `detail`. */
  normal: RgbaImage
  heights: HeightMap
  /** 255 = unoccluded. */
  occlusion: GrayImage
}

export interface MapSettings {
  /** Width and height of the layers' maps in texels. */
  size: number
  /** Width and height of the areas' maps in texels. */
  areaSize: number
  /** Tangent frame of the normal maps. */
  frame: TangentFrame
}

/** Maps of all layers and areas, and the positions of their texels on the skin. */
export interface AutoMaps {
  layers: AutoLayer[]
  /** Weights of each region's area. */
  weights: GrayImage[]
  /** Texels of the layers' maps. */
  texels: SkinTexels
  /** Texels of the areas' maps. */
  areaTexels: SkinTexels
}

/**
 * Draws the maps of all layers and areas.
 *
 * @param layerOf index of each region's layer.
 * @param report called with the finished fraction of the work.
 * @returns undefined if there are no regions.
 */
export function drawMaps(
  prepared: PreparedSkin,
  regions: readonly FittedRegion[],
  layerOf: readonly number[],
  { size, areaSize, frame }: MapSettings,
  report: (fraction: number) => void,
): AutoMaps | undefined {
  // Return before locating the texels, which takes longer than all previous steps.
  if (regions.length === 0) return undefined
  const { skin, surface, face, isDrawn } = prepared
  const texels = new SkinTexels(skin, surface, size, size, isDrawn, MIPMAP_MARGIN)
  const areaTexels = new SkinTexels(skin, surface, areaSize, areaSize, isDrawn)
  const metric = surfaceMetric({ ...skin, positions: inMetres(surface) }, size)
  const layers: AutoLayer[] = []
  const weights: GrayImage[] = []
  const barycentrics = new Float64Array(3)
  const layerCount = Math.max(...layerOf) + 1
  /** Reports that one of the four parts of a layer begins: creases, frames, normals or areas. */
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

/** Returns the strokes of a layer's regions. Lines that the left and the right region share are in a group without a side in its name. */
function strokesOf(regions: readonly FittedRegion[]): Stroke[] {
  const groups = new Map<readonly Stroke[], string>()
  for (const { region, strokes } of regions) {
    groups.set(strokes, groups.has(strokes) ? region.name.replace(/(Left|Right)$/, '') : region.name)
  }
  return [...groups].flatMap(([strokes, group]) => strokes.map((stroke) => ({ group, ...stroke })))
}

/** Returns the positions of a surface, in metres and by vertex of the skin. */
function inMetres({ pointOf, points }: SkinSurface): Float64Array {
  const out = new Float64Array(3 * pointOf.length)
  for (const [vertex, point] of pointOf.entries()) {
    for (let k = 0; k < 3; k++) out[3 * vertex + k] = points[3 * point + k] / 1000
  }
  return out
}
