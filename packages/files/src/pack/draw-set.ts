import { FurrowError, type GrayImage, type WrinkleSetDocument } from 'furrow'
import {
  type HeightMap,
  heightToNormal,
  type SkinCanvas,
  StrokeLayer,
  type StrokesDocument,
  type TangentFrame,
} from 'furrow/author'
import {
  addFurrows,
  BLOOD_AMPLITUDE,
  changedBlood,
  didYouMean,
  fileNamesOf,
  halfSide,
  hasOnset,
  heightLevels,
  resampleHeights,
  valleyBlood,
} from 'furrow/internal'
import type { OutputFile } from '../base/output-file.ts'
import { decodeGray } from '../images/decode-gray.ts'
import { decodeSculpted } from '../images/sculpted-heights.ts'
import { addressOf } from '../wrinkles/folder-document.ts'
import { layersOf } from '../wrinkles/strokes.ts'
import { encodeLayer } from './encode-layer.ts'
import type { ReadFile } from './set-to-pack.ts'

type LayerEntry = WrinkleSetDocument['layers'][number]

/** Maps of a layer that are computed from its strokes (wrinkle lines). */
const DRAWN_MAPS = ['normal', 'occlusion', 'blood', 'onset', 'height'] as const
type DrawnMap = (typeof DRAWN_MAPS)[number]

/** Surface on which strokes are drawn. */
export interface DrawnOn {
  /** Canvas with the size of the normal map. Width and height are even. */
  canvas: SkinCanvas
  /** Tangent frame in which renderers interpret normals. */
  frame: TangentFrame
}

/**
 * Returns the names of the layers whose maps have to be drawn.
 *
 * @param layer draws only this layer. Default: all layers with strokes or furrows.
 * @throws FurrowError if a stroke names a layer that the set lacks, or names no layer although the set has several.
 */
export function layersToDraw(
  { layers }: WrinkleSetDocument,
  document: StrokesDocument,
  layer: string | undefined,
  who: string,
): string[] {
  const names = layers.map(({ name }) => name)
  const unnamed = document.strokes.findIndex((stroke) => stroke.layer === undefined)
  if (unnamed >= 0 && names.length > 1)
    throw noLayer(`strokes[${unnamed}] names no layer`, undefined, names, who)
  const drawn = unnamed >= 0 ? names : layersOf(document)
  const unknown = drawn.find((name) => !names.includes(name))
  if (unknown !== undefined) throw noLayer('the folder has no such layer', unknown, names, who)
  return layer === undefined ? drawn : [layer]
}

function noLayer(
  problem: string,
  value: string | undefined,
  names: readonly string[],
  who: string,
): FurrowError {
  const remedy = didYouMean(value, names, 'name one of them in the document')
  return new FurrowError({ code: 'unknown-name', who, problem, value, limit: names.join(', '), remedy })
}

/** Returns the paths of the maps that are drawn for a layer, relative to the folder of its wrinkle set. */
export function drawnPaths({ layers }: WrinkleSetDocument, layer: string): Record<DrawnMap, string> {
  const names = layers.map(({ name }) => name)
  const folder = fileNamesOf(names)[names.indexOf(layer)]
  const path = (map: DrawnMap) => `layers/${folder}/${map}.png`
  return {
    normal: path('normal'),
    occlusion: path('occlusion'),
    blood: path('blood'),
    onset: path('onset'),
    height: path('height'),
  }
}

/**
 * Draws normals, occlusion, heights, blood and onset of layers, like `furrow auto`. Keeps areas, drivers, all other
 * maps, and blood that was painted by hand.
 *
 * @param read reads a file of the wrinkle set.
 * @returns all layers as entries of `wrinkles.json`, and the drawn images with paths relative to the folder.
 */
export async function drawSet(
  set: WrinkleSetDocument,
  layers: readonly string[],
  document: StrokesDocument,
  read: ReadFile,
  on: DrawnOn,
  who: string,
): Promise<{ layers: LayerEntry[]; files: OutputFile[] }> {
  const files: OutputFile[] = []
  const entries = [...set.layers]
  for (const [i, entry] of entries.entries()) {
    if (!layers.includes(entry.name)) continue
    const maps = await drawLayer(entry, document, read, on, who)
    const paths = drawnPaths(set, entry.name)
    const { height: _, heightAmplitude: __, onset: ___, bloodAmplitude = BLOOD_AMPLITUDE, ...rest } = entry
    entries[i] = {
      ...rest,
      kind: 'detail',
      normal: addressOf(paths.normal),
      occlusion: addressOf(paths.occlusion),
      blood: addressOf(paths.blood),
      bloodAmplitude,
      ...(maps.onset && { onset: addressOf(paths.onset) }),
      ...(maps.height && { height: addressOf(paths.height), heightAmplitude: maps.heightAmplitude! }),
    }
    for (const map of DRAWN_MAPS) {
      const image = maps[map]
      if (image) files.push({ path: paths[map], bytes: image.bytes })
    }
  }
  return { layers: entries, files }
}

async function drawLayer(
  entry: LayerEntry,
  { strokes, furrows }: StrokesDocument,
  read: ReadFile,
  { canvas, frame }: DrawnOn,
  who: string,
) {
  const { name } = entry
  const own = strokes.filter((stroke) => (stroke.layer ?? name) === name)
  const layer = new StrokeLayer(canvas, { frame, onset: hasOnset(own) })
  layer.draw(own)
  if (entry.sculpted !== undefined) layer.sculpt(await readSculpted(entry.sculpted, canvas, read, who))
  const { heights, occlusion, onset } = layer
  const blood = await bloodOf(entry, heights, read, who)
  const maps = { name, normal: normalOf(), heights, occlusion, blood, ...(onset && { onset }) }
  return encodeLayer(maps, own.length > 0 || entry.sculpted !== undefined, false)

  /** Returns the normals. Only normals show fine furrows, which are too shallow for heights. */
  function normalOf() {
    if (!furrows || (furrows.layer ?? name) !== name) return layer.normal
    const withFurrows = { ...heights, data: heights.data.slice() }
    addFurrows(withFurrows, canvas, furrows, strokes)
    return heightToNormal(withFurrows, canvas.metric, frame)
  }
}

/** Reads the sculpted heights of a layer, and resamples them to the size of the canvas. */
async function readSculpted(
  uri: string,
  { metric }: SkinCanvas,
  read: ReadFile,
  who: string,
): Promise<HeightMap> {
  return resampleHeights(await decodeSculpted(await read(uri), uri, who), metric.width, metric.height)
}

/**
 * Computes the blood map of a redrawn layer, with half the width and height of its height map. Replaces the blood in
 * the valleys of the old wrinkle lines by that in the new valleys, see `changedBlood`. Other blood, e.g. painted by
 * hand, stays. Valleys are computed from the 8-bit heights as stored, so that a later run finds the same valleys and
 * can subtract their blood.
 */
async function bloodOf(
  entry: LayerEntry,
  heights: HeightMap,
  read: ReadFile,
  who: string,
): Promise<GrayImage> {
  const { levels, amplitude } = heightLevels(heights.data)
  const lines = valleyBlood(millimetresOf(halfSide({ ...heights, data: levels }), amplitude))
  if (entry.blood === undefined) return lines
  const { blood, height, heightAmplitude = 0 } = entry
  const old = await decodeGray(await read(blood), blood, who)
  const oldHeights = height === undefined ? undefined : await decodeGray(await read(height), height, who)
  for (const [image, path] of [
    [old, blood],
    [oldHeights, height],
  ] as const) {
    if (image && (image.width !== lines.width || image.height !== lines.height))
      throw sizeMismatch(image, path!, lines, who)
  }
  if (!oldHeights) return changedBlood(old, undefined, lines)
  return changedBlood(old, valleyBlood(millimetresOf(oldHeights, heightAmplitude)), lines)
}

function millimetresOf({ width, height, data }: GrayImage, amplitude: number): HeightMap {
  return { width, height, data: Float32Array.from(data, (level) => 1000 * amplitude * (level / 255 - 0.5)) }
}

function sizeMismatch(
  image: GrayImage,
  path: string,
  { width, height }: GrayImage,
  who: string,
): FurrowError {
  return new FurrowError({
    who,
    problem: `${path} differs in size from the drawn maps, so painted blood cannot be kept`,
    value: `${image.width} x ${image.height}`,
    limit: `${width} x ${height}, half the side of the normals`,
    remedy: 'choose another --size, or scale the image',
  })
}
