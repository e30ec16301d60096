import type { AreaConvention } from './area.ts'
import { MAX_BLOOD_AMPLITUDE } from './blood.ts'
import { type JsonReader, orDefault } from './json.ts'
import {
  MAX_AREAS,
  MAX_IMAGE_SIDE,
  MAX_LAYERS,
  MAX_NAME_LENGTH,
  MAX_NUMBER,
  MIN_AREA_SIZE,
} from './limits.ts'
import type { Combine, LayerKind } from './types.ts'

/** Contents of `wrinkles.json`, except the drivers that activate areas. All URLs are relative to this file. */
export interface SetDocument {
  version: 1
  /** Name of the wrinkled mesh or of its node. Read by `furrow pack`. */
  mesh?: string
  /** Name of the wrinkled material. Read by `furrow pack`. */
  material?: string
  /** Maps of fully wrinkled skin. */
  layers: {
    name: string
    kind: LayerKind
    /** URL of the tangent-space normal map, linear, +Y towards smaller v; `layers/NAME/normal.png` by default. */
    normal: string
    /** Factor for x and y of the normals; default 1. */
    normalScale?: number
    /** URL of the base colour map, sRGB. */
    baseColor?: string
    /** URL of the roughness map: G channel, linear. */
    roughness?: string
    /** URL of the occlusion map: R channel, linear. */
    occlusion?: string
    /** 0 = no occlusion, 1 = as in the map; default 1. */
    occlusionStrength?: number
    /** URL of the height map: R channel, linear, 0.5 = undisplaced skin. */
    height?: string
    /** Height difference between black and white, in metres; required with `height`. */
    heightAmplitude?: number
    /** URL of the blood map: B channel or gray image, linear; byte 128 = no change. */
    blood?: string
    /** Amplitude, 0..2: the optical depth for green light that byte 255 of the blood map adds. Required with `blood`. */
    bloodAmplitude?: number
    /** URL of the onset map: G channel or gray image, linear. Larger values delay wrinkles more; 0 = no delay. */
    onset?: string
    /** 0 = the onset map has no effect, 1 = full effect; default 1. */
    onsetStrength?: number
    /** URL of heights that were sculpted by hand. Read by `furrow strokes`, which adds them to the heights of strokes. */
    sculpted?: string
  }[]
  /** Areas of influence: images with the location of each controllable group of wrinkles. */
  areas: {
    name: string
    /** URL of a gray image; `areas/NAME.png` by default. */
    image: string
    /** Name of the layer; default: the first layer. */
    layer?: string
    /** `sum` by default. */
    combine?: Combine
    /** `paper` by default. */
    convention?: AreaConvention
    /** Resting activation, 0..1; default 0. */
    activation?: number
  }[]
  /** Width and height of packed areas in texels; default 128. */
  areaSize?: number
  /** URL of a JSON file with strokes (wrinkle lines as curves). Read by `furrow pack`. */
  strokes?: string
  /** The user's choice of a facial shape for each blendshape with an unknown name. Not checked here; read by `furrow pack`. */
  shapes?: unknown
}

const MAPS = ['baseColor', 'roughness', 'occlusion', 'height', 'blood', 'onset'] as const

/** Maximum length of a URL, in characters. */
const MAX_URL_LENGTH = 2048

/**
 * Reads and checks `wrinkles.json`, except its drivers and shapes.
 *
 * @param json result of `JSON.parse`.
 * @param convention meaning of gray in the images of areas that lack the field `convention`.
 * @throws FurrowError naming the first field that is missing, has the wrong type or is out of range.
 */
export function readSetDocument(
  reader: JsonReader,
  json: unknown,
  convention: AreaConvention,
): SetDocument & { drivers: unknown } {
  const root = reader.object(json, 'the document')
  if (orDefault(root.version, 1) !== 1)
    reader.fail('unknown version', root.version, '1', 'write "version": 1')
  const layers = reader
    .array(root.layers, 'layers', 1, MAX_LAYERS)
    .map((item, i) => readLayer(reader, item, `layers[${i}]`))
  const areas = reader
    .array(root.areas, 'areas', 1, MAX_AREAS)
    .map((item, i) => readArea(reader, item, `areas[${i}]`, convention))
  const names = (['mesh', 'material'] as const).filter((field) => root[field] !== undefined)
  return {
    version: 1,
    ...Object.fromEntries(names.map((field) => [field, reader.text(root[field], field, MAX_NAME_LENGTH)])),
    layers,
    areas,
    drivers: root.drivers,
    ...(root.areaSize !== undefined && {
      areaSize: reader.integer(root.areaSize, 'areaSize', MIN_AREA_SIZE, MAX_IMAGE_SIDE),
    }),
    ...(root.strokes !== undefined && { strokes: reader.text(root.strokes, 'strokes', MAX_URL_LENGTH) }),
    ...(root.shapes !== undefined && { shapes: root.shapes }),
  }
}

function readLayer(reader: JsonReader, item: unknown, at: string): SetDocument['layers'][number] {
  const json = reader.object(item, at)
  const name = reader.name(json.name, `${at}.name`)
  const defaultUrl = `layers/${encodeURIComponent(name)}/normal.png`
  const layer: SetDocument['layers'][number] = {
    name,
    kind: reader.choice(orDefault(json.kind, 'replace'), `${at}.kind`, ['replace', 'detail']),
    normal: reader.text(orDefault(json.normal, defaultUrl), `${at}.normal`, MAX_URL_LENGTH),
  }
  for (const map of MAPS) {
    if (json[map] !== undefined) layer[map] = reader.text(json[map], `${at}.${map}`, MAX_URL_LENGTH)
  }
  if (json.sculpted !== undefined)
    layer.sculpted = reader.text(json.sculpted, `${at}.sculpted`, MAX_URL_LENGTH)
  if (json.normalScale !== undefined) {
    layer.normalScale = reader.number(json.normalScale, `${at}.normalScale`, -MAX_NUMBER, MAX_NUMBER, '')
  }
  for (const field of ['occlusionStrength', 'onsetStrength'] as const) {
    if (json[field] !== undefined) layer[field] = reader.number(json[field], `${at}.${field}`, 0, 1, '')
  }
  if (layer.height !== undefined || json.heightAmplitude !== undefined) {
    layer.heightAmplitude = reader.number(
      json.heightAmplitude,
      `${at}.heightAmplitude`,
      0,
      MAX_NUMBER,
      'metres',
    )
  }
  if (layer.blood !== undefined || json.bloodAmplitude !== undefined) {
    layer.bloodAmplitude = reader.number(
      json.bloodAmplitude,
      `${at}.bloodAmplitude`,
      0,
      MAX_BLOOD_AMPLITUDE,
      '',
    )
  }
  return layer
}

function readArea(
  reader: JsonReader,
  item: unknown,
  at: string,
  convention: AreaConvention,
): SetDocument['areas'][number] {
  const area = reader.object(item, at)
  const name = reader.name(area.name, `${at}.name`)
  const defaultUrl = `areas/${encodeURIComponent(name)}.png`
  return {
    name,
    image: reader.text(orDefault(area.image, defaultUrl), `${at}.image`, MAX_URL_LENGTH),
    ...(area.layer !== undefined && { layer: reader.name(area.layer, `${at}.layer`) }),
    combine: reader.choice<Combine>(orDefault(area.combine, 'sum'), `${at}.combine`, ['sum', 'max']),
    convention: reader.choice<AreaConvention>(orDefault(area.convention, convention), `${at}.convention`, [
      'paper',
      'weight',
    ]),
    ...(area.activation !== undefined && {
      activation: reader.number(area.activation, `${at}.activation`, 0, 1, ''),
    }),
  }
}
