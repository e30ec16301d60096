import { readdir } from 'node:fs/promises'
import { basename, dirname, join } from 'node:path'
import { FurrowError, parseWrinkleSetDocument, type WrinkleSetDocument } from 'furrow'
import { cannotRead } from '../errors.ts'
import { type ReadOptions, referenceReader } from '../gltf/external-files.ts'
import { readJson } from '../inputs.ts'
import { statOf } from '../outputs.ts'
import { MAP_SLOTS } from './wrinkled-file.ts'

type Json = Record<string, unknown>

/** The document of strokes in a folder. */
export const STROKES_FILE = 'strokes.json'

const OPTIONAL_MAPS = MAP_SLOTS.filter(([map]) => map !== 'normal')

/**
 * Reads the wrinkle set of a folder: its `wrinkles.json`, completed by the files in `layers/` and `areas/`, and by
 * `strokes.json`. Without that document, all layers and areas found there are used, in alphabetical order.
 *
 * @param whiteIsVisible the convention of areas that name none.
 * @throws FurrowError when the document is malformed or there are no layers or areas.
 */
export async function readFolder(
  folder: string,
  whiteIsVisible: boolean,
  who: string,
): Promise<WrinkleSetDocument> {
  const path = join(folder, 'wrinkles.json')
  const files = await listFiles(folder, who)
  const json = files.includes('wrinkles.json') ? await readJson(path, who) : { version: 1 }
  if (isObject(json)) {
    json.layers ??= foundLayers(files)
    json.areas ??= foundAreas(files)
    if (json.strokes === undefined && files.includes(STROKES_FILE)) json.strokes = STROKES_FILE
    if (Array.isArray(json.layers)) completeLayers(json.layers, files)
    for (const [list, kind] of [
      [json.layers, 'layers'],
      [json.areas, 'areas'],
    ] as const) {
      if (Array.isArray(list) && list.length === 0) throw noneIn(folder, kind, who)
    }
  }
  return parseWrinkleSetDocument(json, `${who}: ${path}`, whiteIsVisible ? 'weight' : 'paper')
}

/**
 * Reads a file that `wrinkles.json` refers to.
 *
 * @throws FurrowError when it cannot be read, or is outside the folder and `options` do not allow that.
 */
export async function readReferenced(
  folder: string,
  uri: string,
  who: string,
  options: ReadOptions,
): Promise<Uint8Array> {
  const read = referenceReader(join(folder, 'wrinkles.json'), who, options)
  return (await read(uri)).bytes
}

/** The address of a file, relative to `wrinkles.json`: in one, `#`, `?` and `%` would have a meaning. */
export function addressOf(path: string): string {
  return path.split('/').map(encodeURIComponent).join('/')
}

/** Paths of all files below a folder, relative to it, with `/`, sorted. */
async function listFiles(folder: string, who: string): Promise<string[]> {
  if ((await statOf(folder).catch(() => undefined))?.isFile()) throw isFile(folder, who)
  try {
    const all = await readdir(folder, { recursive: true, withFileTypes: false })
    return all.map((name) => name.replaceAll('\\', '/')).sort()
  } catch (error) {
    const remedy = 'name a folder with layers/NAME/normal.png and areas/NAME.png'
    throw cannotRead(who, `the folder ${folder}`, error, { remedy })
  }
}

function isFile(path: string, who: string): FurrowError {
  const isDocument = basename(path) === 'wrinkles.json'
  return new FurrowError({
    who,
    what: `${path} is a file`,
    limit: 'a folder with layers/NAME/normal.png, areas/NAME.png and optionally wrinkles.json',
    remedy: isDocument
      ? `name its folder, ${dirname(path)}`
      : 'make wrinkles for an avatar with furrow auto, or take them out of a file with furrow unpack',
  })
}

function foundLayers(files: readonly string[]): Json[] {
  return matches(files, /^layers\/([^/]+)\/normal\.png$/).map((name) => ({ name }))
}

function foundAreas(files: readonly string[]): Json[] {
  return matches(files, /^areas\/([^/]+)\.png$/).map((name) => ({ name }))
}

/** Adds the optional maps in a layer's folder that the document does not name: a reader of it alone has no default for them. */
function completeLayers(layers: unknown[], files: readonly string[]): void {
  for (const layer of layers) {
    if (!isObject(layer)) continue
    for (const [map] of OPTIONAL_MAPS) {
      const file = `layers/${layer.name}/${map}.png`
      if (layer[map] === undefined && files.includes(file)) layer[map] = addressOf(file)
    }
  }
}

function matches(files: readonly string[], pattern: RegExp): string[] {
  return files.flatMap((file) => pattern.exec(file)?.[1] ?? [])
}

function noneIn(folder: string, kind: 'layers' | 'areas', who: string): FurrowError {
  const file = kind === 'layers' ? 'layers/NAME/normal.png' : 'areas/NAME.png'
  return new FurrowError({
    who,
    what: `no ${kind} in ${folder}`,
    limit: `at least one ${file}`,
    remedy: 'put the images there, or name them in wrinkles.json',
  })
}

function isObject(value: unknown): value is Json {
  return typeof value === 'object' && value !== null && !Array.isArray(value)
}
