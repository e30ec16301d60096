import { BLOOD_AT_REST, MAX_BLOOD_AMPLITUDE } from '../../../core/blood.ts'
import type { GrayImage } from '../../../core/types.ts'
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

/** Area that shows only blood, with its delay. */
export interface BloodArea {
  name: string
  /** Index of its layer. */
  layer: number
  weights: GrayImage
  drivers: [MorphDriver, TimeDriver]
}

/** Blood of automatic wrinkles. */
export interface AutoBlood {
  /** Amplitude of all layers, see `Layer`. */
  amplitude: number
  /** One map per layer. */
  maps: GrayImage[]
  areas: BloodArea[]
}

/** Distance in millimetres over which a flush fades in from the areas of lines on the same layer, which would show the flush. */
const LINE_FADE = 4

export interface BloodSource {
  /** Texels of the layers' maps and of the areas. */
  texels: SkinTexels
  areaTexels: SkinTexels
  layers: readonly { heights: HeightMap }[]
  /** Regions with their lines, and the layer of each. */
  regions: readonly CreasedRegion[]
  layerOf: readonly number[]
}

/**
 * Draws the blood of each layer: valleys are slightly darker. Flushes of a face get their own areas, because blood is slower than lines.
 * Each flush is on the layer with the fewest lines at its place, and fades out near those lines.
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
  // A flush without lines looks like a blot.
  const creased = new Set(source.regions.map(({ region }) => region.name))
  const shown = flushes.filter((flush) => flush.areas.some((area) => creased.has(area)))
  const areas = face ? drawFlushes(face, shown, names, source, maps) : []
  const amplitude = clamp(Math.round(1000 * BLOOD_AMPLITUDE * strength) / 1000, 0, MAX_BLOOD_AMPLITUDE)
  return { amplitude, maps, areas }
}

/** Returns a layer map without blood. */
export function neutralBlood(size: number): GrayImage {
  return { width: size, height: size, data: new Uint8Array(size * size).fill(BLOOD_AT_REST) }
}

/** Adds flushes caused by the face's targets to the layers' maps, and draws their areas. */
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

/** Lines of a layer, with the distance at which flushes fade out. */
interface LineAreas {
  grid: LineGrid
  /** Distance in millimetres that the area around each line extends. */
  extents: number[]
}

function linesOf({ regions, layerOf }: BloodSource, layer: number): LineAreas {
  const extentOf = new Map<LaidStroke, number>()
  for (const { region, creases } of regions.filter((_, i) => layerOf[i] === layer))
    for (const crease of creases)
      extentOf.set(crease, Math.max(extentOf.get(crease) ?? 0, region.reach + region.feather))
  const extents = [...extentOf.values()]
  const reaches = extents.map((extent) => extent + LINE_FADE)
  return { grid: new LineGrid([...extentOf.keys()], reaches), extents }
}

/** Draws the weights of a flush, 255 at its centre, 0 on hidden skin. */
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
 * @param lines lines of its layer, where the flush fades out: neither shows in the other's area.
 * @param visit receives the square root of the fade, 0..1, because map and weights multiply.
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

/** Returns a test whether a flush may reach into a box. Chart heights equal space heights. */
function isNear({ centre, radii }: Flush): (low: Float64Array, high: Float64Array) => boolean {
  return (low, high) => {
    const isBeside = high[1] < centre[1] - radii[1] || low[1] > centre[1] + radii[1] || high[2] <= -60
    if (isBeside) return false
    const [left, right] = acrossOf(low, high)
    return right >= centre[0] - radii[0] && left <= centre[0] + radii[0]
  }
}
