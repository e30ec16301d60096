import { type AreaConvention, FurrowError, parseWrinkleSetDocument, type WrinkleSetDocument } from 'furrow'
import { MAX_BLOOD_AMPLITUDE } from 'furrow/internal'
import { MAP_SLOTS } from './map-slots.ts'

type Json = Record<string, unknown>

/** File name of the document that describes the wrinkle set of a folder. */
export const WRINKLES_FILE = 'wrinkles.json'

/** File name of the document with strokes (wrinkle lines). */
export const STROKES_FILE = 'strokes.json'

const OPTIONAL_MAPS = MAP_SLOTS.filter(([map]) => map !== 'normal')

/** Maps that require an amplitude. `limit` and `typical` are for errors. */
const AMPLITUDES = [
  { map: 'height', limit: 'metres from black to white', typical: 0.002 },
  { map: 'blood', limit: `0 to ${MAX_BLOOD_AMPLITUDE}`, typical: 0.3 },
] as const

/**
 * Returns the wrinkle set of a folder. If `wrinkles.json` omits the layers, the areas, the strokes or an optional map of
 * a layer, this function adds the files in the folder.
 *
 * @param json content of `wrinkles.json`, or undefined if the folder has none.
 * @param files paths of all files in the folder, relative to it, with `/` as separator.
 * @param folder path of the folder, for errors.
 * @param convention whether black or white means visible, for areas without a `convention`.
 * @throws FurrowError if the document is malformed, or the folder has no layers or no areas.
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

/** Converts a path relative to `wrinkles.json` to a URI. Escapes `#`, `?` and `%`. */
export function addressOf(path: string): string {
  return path.split('/').map(encodeURIComponent).join('/')
}

function foundLayers(files: readonly string[]): Json[] {
  return matches(files, /^layers\/([^/]+)\/normal\.png$/).map((name) => ({ name }))
}

function foundAreas(files: readonly string[]): Json[] {
  return matches(files, /^areas\/([^/]+)\.png$/).map((name) => ({ name }))
}

/** Adds optional maps that a layer of the document omits, if the layer's folder has the image, e.g. `blood.png`. */
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

/**
 * Throws if a layer uses a height or blood map in its own folder, e.g. `layers/NAME/height.png`, but has no amplitude.
 * Users cause this when they add the map to the folder and do not edit `wrinkles.json`.
 */
function checkAmplitudes(layer: Json, files: readonly string[], who: string): void {
  for (const { map, limit, typical } of AMPLITUDES) {
    const file = `layers/${layer.name}/${map}.png`
    const amplitude = `${map}Amplitude`
    if (!files.includes(file) || layer[map] !== addressOf(file) || layer[amplitude] !== undefined) continue
    const entry = JSON.stringify({ name: layer.name, [amplitude]: typical })
    throw new FurrowError({
      who,
      problem: `${file} requires ${amplitude}, which its layer in ${WRINKLES_FILE} lacks`,
      limit,
      remedy: `add it to "layers" in ${WRINKLES_FILE}, e.g. ${entry}, or move the map out of the folder`,
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
