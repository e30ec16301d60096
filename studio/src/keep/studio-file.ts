import { AUTO_REGIONS, CLOTH_KINDS, DENSE_REGIONS } from 'furrow/author'
import {
  AUTO_SIDES,
  JsonReader,
  MAX_IMAGE_SIDE,
  MAX_NUMBER,
  parseCorrections,
  SCALE_RANGE,
  SURFACE_KINDS,
} from 'furrow/internal'
import {
  AUTO_AGES,
  AUTO_DENSITIES,
  AUTO_STRENGTHS,
  AUTO_SYMMETRIES,
  type AutoSettings,
  MAP_NAMES,
  type MapName,
  type StudioDocument,
} from '../document/document.ts'
import { MAX_TAKES } from '../document/take.ts'

/**
 * Contents of `studio.json`: project data for which the files of `furrow pack` have no fields. A folder made by hand has no
 * `studio.json`, so the data is optional.
 */
export interface StudioFile {
  version: 1
  /** Millimetres per scene unit. Ignored if the folder contains `strokes.json`, which has its own scale. */
  scale?: number
  mapSize?: number
  auto?: AutoSettings
  /** Names of the automatic areas that the artist has not edited. */
  automaticAreas?: string[]
  /** Indices of the automatic strokes that the artist has not edited. */
  automaticStrokes?: number[]
  /** Names of layers with automatic blood maps. */
  automaticBlood?: string[]
  /** Layers with maps drawn from strokes. The keys are layer names. */
  layers?: Record<string, DrawnLayer>
  face?: FaceFile
  /** Paths of the takes, in their order. */
  takes?: string[]
  /** Paths of the images and takes that the studio wrote. The studio deletes no other files. */
  files?: string[]
}

/** Layer with maps drawn from strokes. */
export interface DrawnLayer {
  drawn: MapName[]
  /** Addresses of the images over which the strokes are drawn. */
  under?: { [Name in MapName]?: string }
  heightAmplitude?: number
}

export interface FaceFile {
  /** Path of the face in the folder. */
  path: string
  /** Path of the face before it was saved to this folder. */
  name: string
}

export const STUDIO_FILE = 'studio.json'
/** Folder for images over which strokes are drawn. */
export const UNDER = 'under'
/** Folder for recorded performances. */
export const TAKES = 'takes'
/** Folder for a face that has several files. */
export const FACE_FOLDER = 'face'

/** Lists the automatic parts of a document. */
export function automaticParts({ layers, areas, strokes }: StudioDocument) {
  return {
    automaticAreas: areas.flatMap(({ name, isAutomatic }) => (isAutomatic ? [name] : [])),
    automaticStrokes: strokes.flatMap(({ isAutomatic }, i) => (isAutomatic ? [i] : [])),
    automaticBlood: layers.flatMap(({ name, isBloodAutomatic }) => (isBloodAutomatic ? [name] : [])),
  }
}

export interface ReadStudioFile {
  studio: StudioFile
  /** Summary of the errors in the file, one line. */
  note?: string
}

/** Maximum length of a path or an address, characters. */
const MAX_PATH = 2048
const MAX_FILES = 5000
/** Maximum number of names in a list, above the maximum numbers of areas and layers. */
const MAX_NAMES = 4096
const MAX_STROKES = 1_000_000

/** Reads `studio.json`. Skips invalid fields, and skips all fields if the version is unknown. `note` describes the errors. */
export function parseStudioFile(json: unknown): ReadStudioFile {
  const errors: string[] = []
  const attempt = <T>(read: () => T): T | undefined => {
    try {
      return read()
    } catch (error) {
      errors.push((error as Error).message)
      return undefined
    }
  }
  const reader = new JsonReader(STUDIO_FILE)
  const fields =
    json === undefined
      ? {}
      : (attempt(() => {
          const object = reader.object(json, 'the document')
          reader.integer(object.version, 'version', 1, 1)
          return object
        }) ?? {})
  const studio: StudioFile = { version: 1 }
  for (const [name, parse] of Object.entries(FIELDS)) {
    const value = fields[name]
    const parsed = value === undefined ? undefined : attempt(() => parse(reader, value, name))
    if (parsed !== undefined) Object.assign(studio, { [name]: parsed })
  }
  if (errors.length === 0) return { studio }
  const others = errors.length > 1 ? ` (and ${errors.length - 1} more)` : ''
  return { studio, note: `Opened without a part of ${STUDIO_FILE}: ${errors[0]}${others}` }
}

type ParseField<T> = (reader: JsonReader, value: unknown, path: string) => T

const FIELDS: { [Name in Exclude<keyof StudioFile, 'version'>]-?: ParseField<StudioFile[Name]> } = {
  scale: (reader, value, path) => reader.number(value, path, ...SCALE_RANGE, 'mm per unit'),
  mapSize: (reader, value, path) => reader.integer(value, path, 16, MAX_IMAGE_SIDE),
  auto: parseAuto,
  automaticAreas: parseNames,
  automaticStrokes: (reader, value, path) =>
    listOf(reader, value, path, MAX_STROKES, (item, at) => reader.integer(item, at, 0, MAX_STROKES)),
  automaticBlood: parseNames,
  layers: (reader, value, path) =>
    Object.fromEntries(
      Object.entries(reader.object(value, path)).map(([name, layer]) => [
        name,
        parseLayer(reader, layer, `${path}.${name}`),
      ]),
    ),
  face: (reader, value, path) => {
    const face = reader.object(value, path)
    const text = (name: keyof FaceFile) => reader.text(face[name], `${path}.${name}`, MAX_PATH)
    return { path: text('path'), name: text('name') }
  },
  takes: (reader, value, path) =>
    listOf(reader, value, path, MAX_TAKES, (item, at) => reader.text(item, at, MAX_PATH)),
  files: (reader, value, path) =>
    listOf(reader, value, path, MAX_FILES, (item, at) => reader.text(item, at, MAX_PATH)),
}

function parseNames(reader: JsonReader, value: unknown, path: string): string[] {
  return listOf(reader, value, path, MAX_NAMES, (item, at) => reader.name(item, at))
}

function listOf<T>(
  reader: JsonReader,
  value: unknown,
  path: string,
  most: number,
  parse: (item: unknown, path: string) => T,
): T[] {
  return reader.array(value, path, 0, most).map((item, i) => parse(item, `${path}[${i}]`))
}

/** Reads the settings of automatic wrinkles. Throws FurrowError at the first invalid field. */
export function parseAuto(reader: JsonReader, value: unknown, path: string): AutoSettings {
  const fields = reader.object(value, path)
  const { age, strength, size, seed, seeds, strengths, densities, symmetry, regions, shapes, kind, cloth } =
    fields
  const seedAt = (value: unknown, path: string) => reader.integer(value, path, 0, 2 ** 32 - 1)
  const byRegion = (
    value: unknown,
    path: string,
    names: readonly string[],
    parse: (value: unknown, path: string) => number,
  ) =>
    Object.fromEntries(
      Object.entries(reader.object(value, path, names)).map(([name, each]) => [
        name,
        parse(each, `${path}.${name}`),
      ]),
    )
  return {
    ...(age !== undefined && { age: reader.number(age, `${path}.age`, ...AUTO_AGES, 'years') }),
    strength: reader.number(strength, `${path}.strength`, ...AUTO_STRENGTHS, ''),
    size: reader.integer(size, `${path}.size`, 16, MAX_IMAGE_SIDE),
    ...(seed !== undefined && { seed: seedAt(seed, `${path}.seed`) }),
    ...(seeds !== undefined && { seeds: byRegion(seeds, `${path}.seeds`, AUTO_REGIONS, seedAt) }),
    ...(strengths !== undefined && {
      strengths: byRegion(strengths, `${path}.strengths`, AUTO_SIDES, (value, at) =>
        reader.number(value, at, AUTO_STRENGTHS[0], MAX_NUMBER, ''),
      ),
    }),
    ...(densities !== undefined && {
      densities: byRegion(densities, `${path}.densities`, DENSE_REGIONS, (value, at) =>
        reader.number(value, at, ...AUTO_DENSITIES, ''),
      ),
    }),
    ...(symmetry !== undefined && {
      symmetry: reader.number(symmetry, `${path}.symmetry`, ...AUTO_SYMMETRIES, ''),
    }),
    ...(regions !== undefined && {
      regions: listOf(reader, regions, `${path}.regions`, AUTO_REGIONS.length, (region, at) =>
        reader.choice(region, at, AUTO_REGIONS),
      ),
    }),
    ...(shapes !== undefined && { shapes: parseCorrections(shapes, `${STUDIO_FILE}: ${path}`) }),
    ...(kind !== undefined && { kind: reader.choice(kind, `${path}.kind`, SURFACE_KINDS) }),
    ...(cloth !== undefined && { cloth: reader.choice(cloth, `${path}.cloth`, CLOTH_KINDS) }),
  }
}

function parseLayer(reader: JsonReader, value: unknown, path: string): DrawnLayer {
  const { drawn, under, heightAmplitude } = reader.object(value, path)
  const parseUnder = (value: unknown, path: string) =>
    Object.fromEntries(
      Object.entries(reader.object(value, path, MAP_NAMES)).map(([map, address]) => [
        map,
        reader.text(address, `${path}.${map}`, MAX_PATH),
      ]),
    )
  return {
    drawn: listOf(reader, drawn, `${path}.drawn`, MAP_NAMES.length, (map, at) =>
      reader.choice(map, at, MAP_NAMES),
    ),
    ...(under !== undefined && { under: parseUnder(under, `${path}.under`) }),
    ...(heightAmplitude !== undefined && {
      heightAmplitude: reader.number(heightAmplitude, `${path}.heightAmplitude`, 0, MAX_NUMBER, 'metres'),
    }),
  }
}
