import { parseDrivers } from 'furrow'
import { parseStrokes } from 'furrow/author'
import {
  JsonReader,
  MAX_AREAS,
  MAX_BLOOD_AMPLITUDE,
  MAX_IMAGE_SIDE,
  MAX_LAYERS,
  MAX_NAME_LENGTH,
  MAX_NUMBER,
  parseCorrections,
} from 'furrow/internal'
import {
  type LayerStroke,
  MAP_NAMES,
  type MapName,
  type StudioArea,
  type StudioDocument,
  type StudioLayer,
} from '../document/document.ts'
import { tileCount } from '../document/sculpted.ts'
import { strokesDocument } from '../document/stroke-document.ts'
import { MAX_TAKES, type Take } from '../document/take.ts'
import { parseAuto } from './studio-file.ts'
import { parseRange, parseShapeNames } from './take-file.ts'

/** Document in the database, with numbers in place of images and of weights of takes. */
export type StoredDocument = Omit<StudioDocument, 'layers' | 'areas' | 'takes'> & {
  layers: StoredLayer[]
  areas: StoredArea[]
  takes?: StoredTake[]
}

type StoredLayer = Omit<StudioLayer, 'maps' | 'sculpted'> & {
  maps: { [Name in MapName]?: number }
  sculpted?: StoredSculpted
}

/** Sculpted heights with numbers in place of tiles. */
export interface StoredSculpted {
  size: number
  tiles: [index: number, number: number][]
}
type StoredTake = Omit<Take, 'motion'> & { names: string[]; weights: number }
type StoredArea = Omit<StudioArea, 'weights'> & { weights: number }

const WHO = 'Studio'

/**
 * Checks a document stored in the browser. Omits unknown fields.
 *
 * @param json value as read from the database.
 * @throws FurrowError for the first missing or invalid field.
 */
export function parseStored(json: unknown): StoredDocument {
  const reader = new JsonReader(WHO)
  const fields = reader.object(json, 'the document')
  const { mesh, material, strokeAreas, furrows, shapes, auto, takes } = fields
  const layers = reader
    .array(fields.layers, 'layers', 1, MAX_LAYERS)
    .map((layer, i) => parseLayer(reader, layer, `layers[${i}]`))
  const areas = reader
    .array(fields.areas, 'areas', 0, MAX_AREAS)
    .map((area, i) => parseArea(reader, area, `areas[${i}]`))
  const layerNames = layers.map(({ name }) => name)
  for (const [i, { layer }] of areas.entries()) reader.choice(layer, `areas[${i}].layer`, layerNames)
  const areaNames = areas.map(({ name }) => name)
  const document = {
    ...(mesh !== undefined && { mesh: reader.text(mesh, 'mesh', MAX_NAME_LENGTH) }),
    ...(material !== undefined && { material: reader.text(material, 'material', MAX_NAME_LENGTH) }),
    scale: reader.number(fields.scale, 'scale', Number.MIN_VALUE, Number.MAX_VALUE, 'mm per unit'),
    mapSize: reader.integer(fields.mapSize, 'mapSize', 1, MAX_IMAGE_SIDE),
    areaSize: reader.integer(fields.areaSize, 'areaSize', 1, MAX_IMAGE_SIDE),
    layers,
    areas,
    strokes: reader.array(fields.strokes, 'strokes', 0, Number.POSITIVE_INFINITY) as LayerStroke[],
    drivers: parseDrivers(fields.drivers, areaNames, WHO),
    ...(strokeAreas !== undefined && { strokeAreas: strokeAreas as StudioDocument['strokeAreas'] }),
    ...(furrows !== undefined && { furrows: furrows as StudioDocument['furrows'] }),
    ...(shapes !== undefined && { shapes: parseCorrections(shapes, WHO) }),
    ...(auto !== undefined && { auto: parseAuto(reader, auto, 'auto') }),
    ...(takes !== undefined && {
      takes: reader
        .array(takes, 'takes', 1, MAX_TAKES)
        .map((take, i) => parseTake(reader, take, `takes[${i}]`)),
    }),
  }
  checkStrokes(reader, document as unknown as StudioDocument, layerNames)
  return document as StoredDocument
}

/** Throws FurrowError if a stroke would be invalid in `strokes.json`. */
function checkStrokes(reader: JsonReader, document: StudioDocument, layers: readonly string[]): void {
  for (const [i, stroke] of document.strokes.entries())
    reader.choice(reader.object(stroke, `strokes[${i}]`).layer, `strokes[${i}].layer`, layers)
  const strokes = strokesDocument(document)
  if (!strokes) return
  // `parseStored` has already checked the size and the scale.
  const { size, scale, ...others } = strokes
  parseStrokes(others)
}

function parseLayer(reader: JsonReader, value: unknown, path: string): StoredLayer {
  const {
    name,
    kind,
    maps,
    normalScale,
    occlusionStrength,
    heightAmplitude,
    bloodAmplitude,
    onsetStrength,
    isBloodAutomatic,
    isOnsetDrawn,
    sculpted,
  } = reader.object(value, path)
  const numbers = Object.entries(reader.object(maps, `${path}.maps`, MAP_NAMES))
  return {
    name: reader.name(name, `${path}.name`),
    kind: reader.choice(kind, `${path}.kind`, ['replace', 'detail']),
    maps: Object.fromEntries(
      numbers.map(([map, number]) => [map, imageNumber(reader, number, `${path}.maps.${map}`)]),
    ),
    normalScale: reader.number(normalScale, `${path}.normalScale`, -MAX_NUMBER, MAX_NUMBER, ''),
    occlusionStrength: reader.number(occlusionStrength, `${path}.occlusionStrength`, 0, 1, ''),
    ...(heightAmplitude !== undefined && {
      heightAmplitude: reader.number(heightAmplitude, `${path}.heightAmplitude`, 0, MAX_NUMBER, 'metres'),
    }),
    ...(bloodAmplitude !== undefined && {
      bloodAmplitude: reader.number(bloodAmplitude, `${path}.bloodAmplitude`, 0, MAX_BLOOD_AMPLITUDE, ''),
    }),
    ...(onsetStrength !== undefined && {
      onsetStrength: reader.number(onsetStrength, `${path}.onsetStrength`, 0, 1, ''),
    }),
    ...(isBloodAutomatic === true && { isBloodAutomatic }),
    ...(isOnsetDrawn === true && { isOnsetDrawn }),
    ...(sculpted !== undefined && { sculpted: parseSculpted(reader, sculpted, `${path}.sculpted`) }),
  }
}

function parseSculpted(reader: JsonReader, value: unknown, path: string): StoredSculpted {
  const fields = reader.object(value, path)
  const size = reader.integer(fields.size, `${path}.size`, 1, MAX_IMAGE_SIDE)
  const tiles = reader.array(fields.tiles, `${path}.tiles`, 1, tileCount(size)).map((item, i) => {
    const at = `${path}.tiles[${i}]`
    const [index, number] = reader.array(item, at, 2, 2)
    return [reader.integer(index, at, 0, tileCount(size) - 1), imageNumber(reader, number, at)] as [
      number,
      number,
    ]
  })
  return { size, tiles }
}

function parseArea(reader: JsonReader, value: unknown, path: string): StoredArea {
  const { name, layer, combine, activation, weights, isAutomatic } = reader.object(value, path)
  return {
    name: reader.name(name, `${path}.name`),
    layer: reader.name(layer, `${path}.layer`),
    combine: reader.choice(combine, `${path}.combine`, ['sum', 'max']),
    activation: reader.number(activation, `${path}.activation`, 0, 1, ''),
    weights: imageNumber(reader, weights, `${path}.weights`),
    ...(isAutomatic === true && { isAutomatic }),
  }
}

function parseTake(reader: JsonReader, value: unknown, path: string): StoredTake {
  const { name, names, weights, range } = reader.object(value, path)
  return {
    name: reader.name(name, `${path}.name`),
    names: parseShapeNames(reader, names, `${path}.names`),
    weights: imageNumber(reader, weights, `${path}.weights`),
    ...(range !== undefined && { range: parseRange(reader, range, `${path}.range`) }),
  }
}

function imageNumber(reader: JsonReader, value: unknown, path: string): number {
  return reader.integer(value, path, 0, Number.MAX_SAFE_INTEGER)
}
