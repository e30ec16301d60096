import { type AreaConvention, FurrowError, parseWrinkleSetDocument, type WrinkleSetDocument } from 'furrow'
import { MAX_BLOOD_AMPLITUDE } from 'furrow/internal'
import { MAP_SLOTS } from './map-slots.ts'

type Json = Record<string, unknown>

/** The wrinkle set's document in a folder. */
export const WRINKLES_FILE = 'wrinkles.json'

/** The document of strokes in a folder. */
export const STROKES_FILE = 'strokes.json'

const OPTIONAL_MAPS = MAP_SLOTS.filter(([map]) => map !== 'normal')

/** The maps that mean nothing without an amplitude: what that may be, and a usual one. */
const AMPLITUDES = [
  { map: 'height', limit: 'metres from black to white', usual: 0.002 },
  { map: 'blood', limit: `0 to ${MAX_BLOOD_AMPLITUDE}`, usual: 0.3 },
] as const

/**
 * The wrinkle set of a folder: its `wrinkles.json`, completed by `strokes.json` and the files in `layers/` and `areas/`.
 *
 * @param json of that document; undefined where there is none.
 * @param files paths of all files in the folder, relative to it, with `/`.
 * @param folder its name, for errors.
 * @param convention of areas that name none.
 * @throws FurrowError when the document is malformed or there are no layers or areas.
 */
export function folderDocument(
  json: unknown,
  files: readonly string[],
  folder: string,
  convention: AreaConvention,
  who: string,
): WrinkleSetDocument {
  const sorted = files.toSorted()
  const document = json === undefined ? { version: 1 } : json
  if (isObject(document)) {
    document.layers ??= foundLayers(sorted)
    document.areas ??= foundAreas(sorted)
    if (document.strokes === undefined && files.includes(STROKES_FILE)) document.strokes = STROKES_FILE
    if (Array.isArray(document.layers)) completeLayers(document.layers, sorted, who)
    for (const [list, kind] of [
      [document.layers, 'layers'],
      [document.areas, 'areas'],
    ] as const) {
      if (Array.isArray(list) && list.length === 0) throw noneIn(folder, kind, who)
    }
  }
  return parseWrinkleSetDocument(
    document,
    `${who}: ${folder.replace(/[\\/]$/, '')}/wrinkles.json`,
    convention,
  )
}

/** The address of a file, relative to `wrinkles.json`: in one, `#`, `?` and `%` would have a meaning. */
export function addressOf(path: string): string {
  return path.split('/').map(encodeURIComponent).join('/')
}

function foundLayers(files: readonly string[]): Json[] {
  return matches(files, /^layers\/([^/]+)\/normal\.png$/).map((name) => ({ name }))
}

function foundAreas(files: readonly string[]): Json[] {
  return matches(files, /^areas\/([^/]+)\.png$/).map((name) => ({ name }))
}

/** Adds the optional maps in a layer's folder that the document does not name: a reader of it alone has no default for them. */
function completeLayers(layers: unknown[], files: readonly string[], who: string): void {
  for (const layer of layers) {
    if (!isObject(layer) || typeof layer.name !== 'string') continue
    for (const [map] of OPTIONAL_MAPS) {
      const file = `layers/${layer.name}/${map}.png`
      if (layer[map] === undefined && files.includes(file)) layer[map] = addressOf(file)
    }
    checkAmplitudes(layer, files, who)
  }
}

/** Whoever has only put a file there has not read of an amplitude. */
function checkAmplitudes(layer: Json, files: readonly string[], who: string): void {
  for (const { map, limit, usual } of AMPLITUDES) {
    const file = `layers/${layer.name}/${map}.png`
    const amplitude = `${map}Amplitude`
    if (!files.includes(file) || layer[map] !== addressOf(file) || layer[amplitude] !== undefined) continue
    const entry = JSON.stringify({ name: layer.name, [amplitude]: usual })
    throw new FurrowError({
      who,
      problem: `${file} needs the ${amplitude} of its layer, which is not in ${WRINKLES_FILE}`,
      limit,
      remedy: `write it into "layers" there, such as ${entry}, or move the file elsewhere`,
    })
  }
}

function matches(files: readonly string[], pattern: RegExp): string[] {
  return files.flatMap((file) => pattern.exec(file)?.[1] ?? [])
}

function noneIn(folder: string, kind: 'layers' | 'areas', who: string): FurrowError {
  const file = kind === 'layers' ? 'layers/NAME/normal.png' : 'areas/NAME.png'
  return new FurrowError({
    who,
    problem: `no ${kind} in ${folder}`,
    limit: `at least one ${file}`,
    remedy: 'put the images there, or name them in wrinkles.json',
  })
}

function isObject(value: unknown): value is Json {
  return typeof value === 'object' && value !== null && !Array.isArray(value)
}
