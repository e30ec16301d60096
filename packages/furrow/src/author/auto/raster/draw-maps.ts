import type { GrayImage, RgbaImage } from '../../../core/types.ts'
import { MIPMAP_MARGIN } from '../../border.ts'
import { type Metric, surfaceMetric } from '../../metric.ts'
import { type TangentFrame, turnedNormals } from '../../normals/height-to-normal.ts'
import { SkinTexels } from '../../skin/skin-texels.ts'
import type { SkinSurface } from '../../skin/surface.ts'
import type { Stroke } from '../../strokes/document.ts'
import { drawStrokes, type HeightMap } from '../../strokes/height.ts'
import { drawOnset } from '../../strokes/onset.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { drawAreas } from './draw-areas.ts'
import type { DrawnRegion } from './drawn-region.ts'
import { FacetFrames } from './facet-frames.ts'

/** Maps of one layer. */
export interface AutoLayer {
  name: string
  /** Wrinkle lines of the layer. Each stroke's `group` is the name of its area. `strokesToHeight` draws `heights` from these strokes. */
  strokes: Stroke[]
  /** Normal map of wrinkles on otherwise flat skin, for a layer of kind `detail`. */
  normal: RgbaImage
  heights: HeightMap
  /** 255 = unoccluded. */
  occlusion: GrayImage
  /** Onset map of the lines, see `strokesToOnset`. Undefined for a layer without lines. */
  onset?: GrayImage
}

export interface MapSettings {
  /** Width and height of the layers' maps in texels. */
  size: number
  /** Width and height of the areas' maps in texels. */
  areaSize: number
  frame: TangentFrame
}

/** Maps of all layers and areas, and the positions of their texels on the skin. */
export interface AutoMaps {
  layers: AutoLayer[]
  /** Weights of each region's area. */
  weights: GrayImage[]
  /** Texels of the layers' maps. */
  texels: SkinTexels
  /** Metric of the layers' maps. */
  metric: Metric
  /** Texels of the areas' maps. */
  areaTexels: SkinTexels
}

/**
 * Draws the maps of all layers and areas.
 *
 * @param layerOf index of each region's layer.
 * @param report called with the finished fraction of the work.
 */
export function drawMaps(
  prepared: PreparedSkin,
  regions: readonly DrawnRegion[],
  layerOf: readonly number[],
  { size, areaSize, frame }: MapSettings,
  report: (fraction: number) => void,
): AutoMaps {
  const { skin, surface, face, isDrawn } = prepared
  const texels = new SkinTexels(skin, surface, size, size, isDrawn, MIPMAP_MARGIN)
  const areaTexels = new SkinTexels(skin, surface, areaSize, areaSize, isDrawn)
  const metric = surfaceMetric({ ...skin, positions: inMetres(surface) }, size)
  const layers: AutoLayer[] = []
  const weights: GrayImage[] = []
  const barycentrics = new Float64Array(3)
  const layerCount = Math.max(-1, ...layerOf) + 1
  /** Reports the start of one of the four parts of a layer's work: creases, frames, normals or areas. */
  const reportPart = (layer: number, part: number) => report((layer + part / 4) / layerCount)
  for (let layer = 0; layer < layerCount; layer++) {
    reportPart(layer, 0)
    const members = [...regions.keys()].filter((i) => layerOf[i] === layer)
    const own = members.map((i) => regions[i])
    const strokes = strokesOf(own)
    const creases = [...new Set(own.map(({ creases }) => creases))]
    const drawn = drawStrokes(creases.flat(), { texels, metric })
    const onset = drawOnset(creases, { texels })
    reportPart(layer, 1)
    const frames = frame === 'derivative' ? new FacetFrames(prepared, own) : undefined
    reportPart(layer, 2)
    const normal = turnedNormals(drawn.heights, metric, frame, (texel, slope) =>
      frames?.turn(texels.locate(texel, barycentrics), barycentrics, slope),
    )
    layers.push({ name: `auto${layer + 1}`, strokes, normal, ...drawn, onset })
    reportPart(layer, 3)
    for (const [k, image] of drawAreas(areaTexels, own, face?.chart).entries()) weights[members[k]] = image
  }
  return { layers, weights, texels, metric, areaTexels }
}

/** Returns the strokes of a layer's regions. Lines that the left and the right region share are in a group without a side in its name. */
function strokesOf(regions: readonly DrawnRegion[]): Stroke[] {
  const groups = new Map<readonly Stroke[], string>()
  for (const { region, strokes } of regions) {
    groups.set(strokes, groups.has(strokes) ? region.name.replace(/(Left|Right)$/, '') : region.name)
  }
  return [...groups].flatMap(([strokes, group]) => strokes.map((stroke) => ({ group, ...stroke })))
}

/** Returns, for each vertex of the skin, its position on the surface in metres. */
function inMetres({ pointOf, points }: SkinSurface): Float64Array {
  const out = new Float64Array(3 * pointOf.length)
  for (const [vertex, point] of pointOf.entries()) {
    for (let k = 0; k < 3; k++) out[3 * vertex + k] = points[3 * point + k] / 1000
  }
  return out
}
