import { BLOOD_AT_REST, MAX_BLOOD_AMPLITUDE } from '../../../core/blood.ts'
import type { GrayImage } from '../../../core/types.ts'
import type { BoneDriver } from '../../../drivers/bone/definition.ts'
import type { MorphDriver } from '../../../drivers/morph/definition.ts'
import type { TimeDriver } from '../../../drivers/time/definition.ts'
import { clamp, smoothstep } from '../../../math/scalar.ts'
import type { SkinTexels } from '../../skin/skin-texels.ts'
import type { HeightMap } from '../../strokes/height.ts'
import type { LaidStroke } from '../../strokes/lay-out.ts'
import { LineGrid } from '../../strokes/line-grid.ts'
import { BLOOD_AMPLITUDE, bloodByte, valleyBlood } from '../../valley-blood.ts'
import type { CreasedRegion } from '../lines/crease.ts'
import { visibility } from '../raster/visibility.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import { acrossOf, unroll } from '../surface/head-chart.ts'
import { poseOf } from '../surface/pose.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { type Flush, fadeOf, flushesOf } from './flushes.ts'

/** Area of influence that shows only blood: reddened or pale skin. */
export interface BloodArea {
  name: string
  /** Index of the area's layer. */
  layer: number
  weights: GrayImage
  /** The first driver activates the area when blendshapes or joints move. The time driver delays the activation. */
  drivers: [MorphDriver | BoneDriver, TimeDriver]
}

/** Blood maps of automatic wrinkles, and areas that show only blood. */
export interface AutoBlood {
  /** Optical depth of blood, for green light, where a map has the value 255. */
  amplitude: number
  /** One map per layer. */
  maps: GrayImage[]
  areas: BloodArea[]
}

/**
 * Distance in millimetres over which a flush (a part of the face that reddens or turns pale) fades out towards the areas of wrinkle lines in
 * its layer. Drivers of wrinkle lines have no delay, so where a flush overlapped their areas, it would appear at once.
 */
const LINE_FADE = 4

/**
 * Fraction of an area's feather at which a flush may begin. The area's weight is at most 0.22 there. If flushes began only where the weight
 * is 0, almost no skin between the brows would have room for one.
 */
const FADED = 0.7

/** Layers and areas for which blood is drawn. */
export interface BloodSource {
  /** Texels of the layers' maps. */
  texels: SkinTexels
  /** Texels of the areas' maps. */
  areaTexels: SkinTexels
  layers: readonly { heights: HeightMap }[]
  regions: readonly CreasedRegion[]
  /** Index of each region's layer. */
  layerOf: readonly number[]
}

/**
 * Draws the blood map of each layer. Valleys of wrinkles get more blood, so they look slightly darker. Flushes get separate areas, because
 * blood reacts more slowly than wrinkles. A flush is drawn on the layer where it overlaps the areas of lines least.
 *
 * @param strength factor on the amplitude.
 */
export function drawBlood(
  { face, names, isMirrored }: Pick<PreparedSkin, 'face' | 'names' | 'isMirrored'>,
  source: BloodSource,
  strength: number,
): AutoBlood {
  const maps = source.layers.map(({ heights }) => valleyBlood(heights))
  const flushes = face ? flushesOf(face.landmarks, isMirrored) : []
  // A flush on skin without wrinkle lines would look like a stain, so it is left out.
  const creased = new Set(source.regions.map(({ region }) => region.name))
  const shown = flushes.filter((flush) => flush.areas.some((area) => creased.has(area)))
  const areas = face ? drawFlushes(face, shown, names, source, maps) : []
  const amplitude = clamp(Math.round(1000 * BLOOD_AMPLITUDE * strength) / 1000, 0, MAX_BLOOD_AMPLITUDE)
  return { amplitude, maps, areas }
}

/** Returns a blood map that changes nothing. */
export function neutralBlood(size: number): GrayImage {
  return { width: size, height: size, data: new Uint8Array(size * size).fill(BLOOD_AT_REST) }
}

/** Adds flushes to the blood maps of the layers, and draws the areas of the flushes. Skips flushes that no blendshape of the face causes. */
function drawFlushes(
  face: DetectedFace,
  flushes: readonly Flush[],
  names: readonly string[],
  source: BloodSource,
  maps: readonly GrayImage[],
): BloodArea[] {
  const areas: BloodArea[] = []
  const lines = source.layers.map((_, layer) => linesOf(source, layer))
  for (const flush of flushes) {
    const targets = [...poseOf(face.find, flush.cause)].map(([target, weight]) => ({
      name: names[target],
      weight,
    }))
    if (targets.length === 0) continue
    const drawn = lines.map((areas) => drawArea(face, source.areaTexels, flush, areas))
    const visible = drawn.map(({ data }) => data.reduce((sum, weight) => sum + weight, 0))
    const layer = visible.indexOf(Math.max(...visible))
    if (visible[layer] === 0) continue
    addFlush(source.texels, flush, lines[layer], maps[layer])
    const { name: area, attack, release } = flush
    areas.push({
      name: area,
      layer,
      weights: drawn[layer],
      drivers: [
        {
          type: 'morph',
          area,
          targets,
          rule: 'sum',
          curve: [
            [0.1, 0],
            [1, 1],
          ],
        },
        { type: 'time', area, attack, release },
      ],
    })
  }
  return areas
}

/** Lines of a layer, and the sizes of the areas around them. */
interface LineAreas {
  grid: LineGrid
  /** Distance in millimetres from each line at which its area has faded enough for a flush to begin. */
  extents: number[]
}

function linesOf({ regions, layerOf }: BloodSource, layer: number): LineAreas {
  const extentOf = new Map<LaidStroke, number>()
  for (const { region, creases } of regions.filter((_, i) => layerOf[i] === layer))
    for (const crease of creases)
      extentOf.set(crease, Math.max(extentOf.get(crease) ?? 0, region.reach + FADED * region.feather))
  const extents = [...extentOf.values()]
  const reaches = extents.map((extent) => extent + LINE_FADE)
  return { grid: new LineGrid([...extentOf.keys()], reaches), extents }
}

/** Draws the area of a flush: the weight is 255 at the flush's centre, and 0 on skin that is hidden, such as inside the mouth. */
function drawArea({ chart }: DetectedFace, texels: SkinTexels, flush: Flush, lines: LineAreas): GrayImage {
  const { width, height } = texels
  const data = new Uint8Array(width * height)
  visitFlush(texels, flush, lines, (texel, share, [x, y, z], normal) => {
    data[texel] = Math.round(255 * share * visibility(chart, x, y, z, normal))
  })
  return { width, height, data }
}

function addFlush(texels: SkinTexels, flush: Flush, lines: LineAreas, { data }: GrayImage): void {
  visitFlush(texels, flush, lines, (texel, share) => {
    const own = (data[texel] - BLOOD_AT_REST) / (255 - BLOOD_AT_REST)
    data[texel] = bloodByte(own + flush.amount * share)
  })
}

/**
 * Visits the texels of a flush.
 *
 * @param lines lines of the flush's layer. The flush fades out towards their areas.
 * @param visit receives as `share` the square root of the flush's strength, 0..1. Blood map and area both use the square root, because
 *   they are multiplied when drawn.
 */
function visitFlush(
  texels: SkinTexels,
  flush: Flush,
  { grid, extents }: LineAreas,
  visit: (texel: number, share: number, position: Float64Array, normal: Float64Array) => void,
): void {
  texels.visitNear(isNear(flush), (texel, position, normal) => {
    const fade = fadeOf(flush, unroll(position[0], position[1], position[2]))
    if (fade === 0) return
    let outside = LINE_FADE
    grid.visit(position, normal, (line, distance) => {
      outside = Math.min(outside, distance - extents[line])
    })
    const clear = smoothstep(outside / LINE_FADE)
    if (clear > 0) visit(texel, Math.sqrt(fade * clear), position, normal)
  })
}

/** Returns a function that tests whether a flush may reach into a box. The box is given by its lowest and highest x, y and z. */
function isNear({ centre, radii }: Flush): (low: Float64Array, high: Float64Array) => boolean {
  return (low, high) => {
    const isBeside = high[1] < centre[1] - radii[1] || low[1] > centre[1] + radii[1] || high[2] <= -60
    if (isBeside) return false
    const [left, right] = acrossOf(low, high)
    return right >= centre[0] - radii[0] && left <= centre[0] + radii[0]
  }
}
