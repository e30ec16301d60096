import { ImageUtils } from '@gltf-transform/core'
import { areaWeights, type GrayImage, type WrinkleSetDocument } from 'furrow'
import { parseStrokes, type StrokesDocument } from 'furrow/author'
import {
  DEFAULT_AREA_SIZE,
  imageTypeOf,
  parseCorrections,
  resampleGray,
  resampleHeights,
} from 'furrow/internal'
import { decodeSculpted, folderDocument, WRINKLES_FILE } from 'furrow-files'
import {
  AUTO_SETTINGS,
  type ImageFile,
  type LayerStroke,
  MAP_NAMES,
  type MapName,
  type StudioArea,
  type StudioDocument,
  type StudioLayer,
} from '../document/document.ts'
import { findNamed, freeName } from '../document/names.ts'
import { type Sculpted, sculptedOf, sculptedSize } from '../document/sculpted.ts'
import type { Take } from '../document/take.ts'
import { bytesOf } from '../files/dropped-files.ts'
import { Folder } from '../files/folder.ts'
import type { AvatarFile } from '../files/folder-files.ts'
import {
  FACE_FOLDER,
  parseStudioFile,
  type ReadStudioFile,
  STUDIO_FILE,
  type StudioFile,
} from './studio-file.ts'
import { parseTakeFile } from './take-file.ts'

const WHO = 'Studio'

/** Defaults for folders without these values: `scale` in millimetres per scene unit, `mapSize` (side of a map) in texels. */
const DEFAULTS = { scale: 1000, mapSize: 1024 } as const
/** Maps that count as drawn from strokes in folders without `studio.json`. */
const DRAWN: readonly MapName[] = ['normal', 'occlusion', 'height', 'onset']
/** Maps that count as drawn from sculpted heights in such folders, if the layer has no strokes. */
const SCULPTED: readonly MapName[] = ['normal', 'height']

/** Decodes a gray image. Throws FurrowError if it is invalid. */
export type DecodeGray = (bytes: Uint8Array, path: string, who: string) => Promise<GrayImage>

export interface ReadFolder {
  document: StudioDocument
  /** Files of the avatar: the glTF or VRM file, followed by the files that it references. Empty if the folder contains no avatar. */
  face: AvatarFile[]
  /** Messages about parts that were skipped, one sentence each. */
  notes: string[]
}

/**
 * Reads a project folder: the files that `furrow pack` reads, and `studio.json`. Skips maps that were drawn from strokes, because the studio
 * draws them again.
 *
 * @param files all files, with paths relative to the folder.
 * @param name folder name, for errors.
 * @throws FurrowError for the first missing or invalid file, except `studio.json` and takes: their errors become notes.
 */
export async function readFolder(
  files: readonly AvatarFile[],
  name: string,
  decode: DecodeGray,
): Promise<ReadFolder> {
  const folder = new Folder(files, name)
  const { studio, note } = await readStudioFile(folder)
  const { takes, notes } = await readTakes(folder, studio)
  const set = setOf(await folder.json(WRINKLES_FILE), folder)
  const strokes = await strokesOf(folder, set)
  const { areaSize = DEFAULT_AREA_SIZE } = set
  const scale = strokes ? strokes.scale : studio.scale
  const mapSize = studio.mapSize ?? strokes?.size ?? (await sideOf(folder, set))
  const isAutomatic = new Set(studio.automaticStrokes)
  const shapes = parseCorrections(set.shapes, `${WHO}: ${WRINKLES_FILE}`)
  const auto =
    studio.auto ?? (strokes?.seed !== undefined ? { ...AUTO_SETTINGS, seed: strokes.seed } : undefined)
  const document: StudioDocument = {
    ...(set.mesh !== undefined && { mesh: set.mesh }),
    ...(set.material !== undefined && { material: set.material }),
    scale: scale ?? DEFAULTS.scale,
    mapSize: mapSize ?? DEFAULTS.mapSize,
    areaSize,
    layers: await Promise.all(
      set.layers.map((layer) => readLayer(folder, layer, strokes, studio, mapSize ?? DEFAULTS.mapSize)),
    ),
    areas: await Promise.all(set.areas.map((area) => readArea(folder, area, set, decode, studio))),
    strokes: (strokes?.strokes ?? []).map((stroke, i): LayerStroke => {
      const layer = findNamed(set.layers, stroke.layer ?? set.layers[0].name, 'layer').name
      return { ...stroke, layer, ...(isAutomatic.has(i) && { isAutomatic: true }) }
    }),
    ...(strokes?.areas && { strokeAreas: strokes.areas }),
    ...(strokes?.furrows && { furrows: strokes.furrows }),
    drivers: set.drivers ?? [],
    ...(shapes.length > 0 && { shapes }),
    ...(auto && { auto }),
    ...(takes.length > 0 && { takes }),
  }
  return { document, face: faceOf(files, studio), notes: [...(note === undefined ? [] : [note]), ...notes] }
}

/** Reads `studio.json`. If its JSON is invalid, returns no data and a note. */
async function readStudioFile(folder: Folder): Promise<ReadStudioFile> {
  try {
    return parseStudioFile(await folder.json(STUDIO_FILE))
  } catch (error) {
    return { studio: { version: 1 }, note: (error as Error).message }
  }
}

/** Reads the takes that `studio.json` lists. Skips takes that are missing or invalid, and returns a note about each. */
async function readTakes(
  folder: Folder,
  { takes: paths = [] }: StudioFile,
): Promise<{ takes: Take[]; notes: string[] }> {
  const takes: Take[] = []
  const notes: string[] = []
  for (const path of paths) {
    try {
      const take = parseTakeFile(await folder.json(path), path)
      takes.push({ ...take, name: freeName(takes, take.name) })
    } catch (error) {
      notes.push((error as Error).message)
    }
  }
  return { takes, notes }
}

function setOf(json: unknown, { paths, name }: Folder): WrinkleSetDocument {
  const areas = (json as { areas?: unknown } | undefined)?.areas
  const hasNoAreas = Array.isArray(areas) && areas.length === 0
  if (!hasNoAreas) return folderDocument(json, paths, name, 'paper', WHO)
  // `folderDocument` rejects folders without areas, but a new project can have none. Add a temporary area for its checks.
  const begun = { ...(json as object), areas: [{ name: 'none' }] }
  return { ...folderDocument(begun, paths, name, 'paper', WHO), areas: [] }
}

async function strokesOf(folder: Folder, set: WrinkleSetDocument): Promise<StrokesDocument | undefined> {
  const json = set.strokes === undefined ? undefined : await folder.json(set.strokes)
  return json === undefined ? undefined : parseStrokes(json)
}

/** Returns the width of the first normal map in texels, or undefined if there is none or it is not square. */
async function sideOf(folder: Folder, { layers }: WrinkleSetDocument): Promise<number | undefined> {
  const address = layers.find(({ normal }) => normal !== undefined)?.normal
  if (address === undefined) return undefined
  const bytes = await bytesOf(folder.file(address), address)
  const [width, height] = ImageUtils.getSize(bytes, imageTypeOf(bytes) ?? '') ?? []
  return width === height ? width : undefined
}

async function readLayer(
  folder: Folder,
  entry: WrinkleSetDocument['layers'][number],
  strokes: StrokesDocument | undefined,
  studio: StudioFile,
  mapSize: number,
): Promise<StudioLayer> {
  const { name, kind, normalScale = 1, occlusionStrength = 1, heightAmplitude } = entry
  const { bloodAmplitude, onsetStrength } = entry
  const hasStrokes = strokes?.strokes.some((stroke) => (stroke.layer ?? name) === name) ?? false
  const known = studio.layers?.[name]
  const sculpted = await readSculpted(folder, entry.sculpted, mapSize)
  const isRaised = hasStrokes || sculpted !== undefined
  const withoutRecord = hasStrokes ? DRAWN : SCULPTED
  const drawn = new Set(known?.drawn ?? (isRaised && !studio.layers ? withoutRecord : []))
  const amplitude = drawn.has('height') ? known?.heightAmplitude : heightAmplitude
  const maps = await Promise.all(
    MAP_NAMES.map(async (map): Promise<[MapName, ImageFile] | undefined> => {
      const address = drawn.has(map) ? known?.under?.[map] : entry[map]
      if (address === undefined) return undefined
      const bytes = await bytesOf(folder.file(address), address)
      return [map, { mimeType: imageTypeOf(bytes) ?? 'image/png', bytes }]
    }),
  )
  return {
    name,
    kind,
    maps: Object.fromEntries(maps.filter((each) => each !== undefined)),
    normalScale,
    occlusionStrength,
    ...(amplitude !== undefined && { heightAmplitude: amplitude }),
    ...(bloodAmplitude !== undefined && { bloodAmplitude }),
    ...(onsetStrength !== undefined && { onsetStrength }),
    ...(studio.automaticBlood?.includes(name) && entry.blood !== undefined && { isBloodAutomatic: true }),
    ...(drawn.has('onset') && entry.onset !== undefined && { isOnsetDrawn: true }),
    ...(sculpted && sculpted.tiles.size > 0 && { sculpted }),
  }
}

/** Reads sculpted heights, and resamples them to the size that fits the maps. */
async function readSculpted(
  folder: Folder,
  address: string | undefined,
  mapSize: number,
): Promise<Sculpted | undefined> {
  if (address === undefined) return undefined
  const bytes = await bytesOf(folder.file(address), address)
  const size = sculptedSize(mapSize)
  return sculptedOf(resampleHeights(await decodeSculpted(bytes, address, WHO), size, size))
}

async function readArea(
  folder: Folder,
  { name, image, layer, combine = 'sum', convention, activation = 0 }: WrinkleSetDocument['areas'][number],
  { layers, areaSize = DEFAULT_AREA_SIZE }: WrinkleSetDocument,
  decode: DecodeGray,
  { automaticAreas }: StudioFile,
): Promise<StudioArea> {
  const gray = await decode(await bytesOf(folder.file(image), image), image, WHO)
  return {
    name,
    layer: findNamed(layers, layer ?? layers[0].name, 'layer').name,
    combine,
    activation,
    weights: resampleGray(areaWeights(gray, convention, `${WHO}: ${image}`), areaSize),
    ...(automaticAreas?.includes(name) && { isAutomatic: true }),
  }
}

function faceOf(files: readonly AvatarFile[], { face }: StudioFile): AvatarFile[] {
  const found = files.find(({ path }) => path === (face?.path ?? 'face.glb'))
  if (!found) return []
  const folder = `${FACE_FOLDER}/`
  if (!found.path.startsWith(folder)) return [{ path: face?.name ?? found.path, file: found.file }]
  const beside = files.filter((file) => file.path.startsWith(folder) && file !== found)
  return [found, ...beside].map(({ path, file }) => ({ path: path.slice(folder.length), file }))
}
