import { join } from 'node:path'
import type { WrinkleSetDocument } from 'furrow'
import type { StrokesDocument } from 'furrow/author'
import { paintedNames } from 'furrow/internal'
import { statOf } from '../disk/file-status.ts'
import { readJson } from '../disk/read-bytes.ts'
import { readFolder } from '../wrinkles/folder.ts'
import { addressOf, STROKES_FILE, WRINKLES_FILE } from '../wrinkles/folder-document.ts'
import { layersOf } from '../wrinkles/strokes.ts'
import { drawnPaths, layersToDraw } from './draw-set.ts'

/** Wrinkle set in a folder, with the files that drawing its strokes writes. */
export interface OpenSet {
  folder: string
  set: WrinkleSetDocument
  /** Parsed content of `wrinkles.json`, before defaults are filled in. */
  json: object
  /** Whether the folder had no `wrinkles.json`. */
  isNew: boolean
  /** Names of the layers to draw. */
  layers: string[]
  /** Path of `wrinkles.json`. */
  document: string
  /** Paths of the images to write: maps of `layers`, and the areas of a new set. */
  images: string[]
}

/** Name of the layer if no stroke names one. */
const DEFAULT_LAYER = 'expression'

/**
 * Reads the wrinkle set of a folder. If there is none, creates a set with the layers and areas of a strokes document.
 *
 * @param layer the only layer to draw. Default: all layers with strokes or furrows.
 * @throws FurrowError if the set is malformed, or lacks a layer that a stroke names.
 */
export async function openSet(
  folder: string,
  strokes: StrokesDocument,
  layer: string | undefined,
  who: string,
): Promise<OpenSet> {
  const document = join(folder, WRINKLES_FILE)
  const isNew = (await statOf(document)) === undefined
  const set = isNew ? setOf(strokes) : await readFolder(folder, false, who)
  const json = isNew ? set : ((await readJson(document, who)) as object)
  const layers = layersToDraw(set, strokes, layer, who)
  const maps = layers.flatMap((name) => Object.values(drawnPaths(set, name)))
  const paths = [...maps, ...(isNew ? set.areas.map(({ name }) => `areas/${name}.png`) : [])]
  return { folder, set, json, isNew, layers, document, images: paths.map((path) => join(folder, path)) }
}

/**
 * Creates a set with the layers and areas of a strokes document. An area is on the layer of the first stroke in one of
 * its groups.
 */
function setOf(document: StrokesDocument): WrinkleSetDocument {
  const { strokes, areas } = document
  const named = layersOf(document)
  const layers = named.length > 0 ? named : [DEFAULT_LAYER]
  return {
    version: 1,
    layers: layers.map((name) => ({ name, kind: 'detail', normal: '' })),
    areas: paintedNames(document).map((name) => {
      const shapes = areas?.find((area) => area.name === name)?.shapes ?? []
      const groups = areas ? shapes.flatMap((shape) => ('group' in shape ? shape.group : [])) : [name]
      const layer = strokes.find(({ group }) => group !== undefined && groups.includes(group))?.layer
      return { name, image: addressOf(`areas/${name}.png`), ...(layer !== undefined && { layer }) }
    }),
    strokes: STROKES_FILE,
  }
}
