import { access, readdir, readFile } from 'node:fs/promises'
import { join } from 'node:path'
import { fileURLToPath, pathToFileURL } from 'node:url'
import { FurrowError, parseWrinkleSetDocument, type WrinkleSetDocument } from 'furrow'
import { firstLine } from '../images.ts'

/** The maps a layer's folder may hold, `NAME.png` each. */
const MAPS = ['normal', 'baseColor', 'roughness', 'occlusion', 'height'] as const

type Json = Record<string, unknown>

/**
 * Reads what a folder says of its wrinkles: its `wrinkles.json`, completed by the files that lie in `layers/` and
 * `areas/`. Without that document every layer and area found there counts, in alphabetical order.
 *
 * @throws FurrowError when the document is malformed or there are no layers or areas.
 */
export async function readFolder(
  folder: string,
  whiteIsVisible: boolean,
  who: string,
): Promise<WrinkleSetDocument> {
  const path = join(folder, 'wrinkles.json')
  const files = await filesOf(folder, who)
  const json = await readDocument(path, files, who)
  if (isObject(json)) {
    json.layers ??= foundLayers(files)
    json.areas ??= foundAreas(files)
    if (Array.isArray(json.layers)) completeLayers(json.layers, files)
    for (const [list, kind] of [
      [json.layers, 'layers'],
      [json.areas, 'areas'],
    ] as const) {
      if (Array.isArray(list) && list.length === 0) throw nothingIn(folder, kind, who)
    }
  }
  return parseWrinkleSetDocument(json, `${who}: ${path}`, whiteIsVisible ? 'weight' : 'paper')
}

/** A file that the document names, wherever it lies on this computer. */
export async function readBeside(folder: string, address: string, who: string): Promise<Uint8Array> {
  let path = join(folder, address)
  try {
    path = fileURLToPath(new URL(address, pathToFileURL(join(folder, 'wrinkles.json'))))
    return await readFile(path)
  } catch (error) {
    throw new FurrowError({
      who,
      what: `cannot read ${path} (${firstLine(error)})`,
      remedy: 'check the name in wrinkles.json and the file',
    })
  }
}

/** Paths of the folder's files that matter, relative to it, with `/`. */
async function filesOf(folder: string, who: string): Promise<string[]> {
  try {
    await access(folder)
    const all = await readdir(folder, { recursive: true, withFileTypes: false })
    return all.map((name) => name.replaceAll('\\', '/')).sort()
  } catch (error) {
    throw new FurrowError({
      who,
      what: `cannot read the folder ${folder} (${firstLine(error)})`,
      remedy: 'name a folder with layers/NAME/normal.png and areas/NAME.png',
    })
  }
}

async function readDocument(path: string, files: readonly string[], who: string): Promise<unknown> {
  if (!files.includes('wrinkles.json')) return { version: 1 }
  try {
    return JSON.parse(await readFile(path, 'utf8'))
  } catch (error) {
    throw new FurrowError({
      who,
      what: `${path} is no JSON (${firstLine(error)})`,
      remedy: 'correct the file',
    })
  }
}

function foundLayers(files: readonly string[]): Json[] {
  return matches(files, /^layers\/([^/]+)\/normal\.png$/).map((name) => ({ name }))
}

function foundAreas(files: readonly string[]): Json[] {
  return matches(files, /^areas\/([^/]+)\.png$/).map((name) => ({
    name,
    image: encodeURI(`areas/${name}.png`),
  }))
}

/** A map that lies in the layer's folder need not be named in the document. */
function completeLayers(layers: unknown[], files: readonly string[]): void {
  for (const layer of layers) {
    if (!isObject(layer)) continue
    for (const map of MAPS) {
      const file = `layers/${layer.name}/${map}.png`
      if (layer[map] === undefined && files.includes(file)) layer[map] = encodeURI(file)
    }
  }
}

function matches(files: readonly string[], pattern: RegExp): string[] {
  return files.flatMap((file) => pattern.exec(file)?.[1] ?? [])
}

function nothingIn(folder: string, kind: 'layers' | 'areas', who: string): FurrowError {
  const file = kind === 'layers' ? 'layers/NAME/normal.png' : 'areas/NAME.png'
  return new FurrowError({
    who,
    what: `no ${kind} in ${folder}`,
    limit: `at least one ${file}`,
    remedy: `put the images there, or name them in wrinkles.json`,
  })
}

function isObject(value: unknown): value is Json {
  return typeof value === 'object' && value !== null && !Array.isArray(value)
}
