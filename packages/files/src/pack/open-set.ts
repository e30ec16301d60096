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

/** A wrinkle set in a folder, whose layers strokes are drawn into. */
export interface OpenSet {
  folder: string
  set: WrinkleSetDocument
  /** Its document as it is written. */
  json: object
  /** Whether the folder had none. */
  isNew: boolean
  /** Names of the layers to draw. */
  layers: string[]
  /** Paths of the files that are written: `wrinkles.json`, and images. */
  document: string
  images: string[]
}

/** Name of the layer of strokes that name none. */
const ONLY_LAYER = 'expression'

/**
 * Reads the wrinkle set of a folder, or plans one with the layers and areas of a document of strokes.
 *
 * @param layer the only one to draw.
 * @throws FurrowError when the set is malformed, or has not all layers of the strokes.
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

/** A set of the layers of a document and its areas, each on the layer of the strokes that it is painted round. */
function setOf(document: StrokesDocument): WrinkleSetDocument {
  const { strokes, areas } = document
  const named = layersOf(document)
  const layers = named.length > 0 ? named : [ONLY_LAYER]
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
