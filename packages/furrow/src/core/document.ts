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

/** The layers and areas of `wrinkles.json`; image URLs are relative to it. */
export interface SetDocument {
  version: 1
  /** Name of the wrinkled mesh or its node; for `furrow pack`. */
  mesh?: string
  /** Name of the wrinkled material; for `furrow pack`. */
  material?: string
  layers: {
    name: string
    kind: LayerKind
    /** Tangent-space normal map, linear, +Y towards smaller v; `layers/NAME/normal.png` by default. */
    normal: string
    /** Factor for x and y of the normals; default 1. */
    normalScale?: number
    /** Skin colour, sRGB. */
    baseColor?: string
    /** Roughness in the G channel, linear. */
    roughness?: string
    /** Occlusion in the R channel, linear. */
    occlusion?: string
    /** 0 = no occlusion, 1 = as in the map; default 1. */
    occlusionStrength?: number
    /** Height in the R channel, linear, 0.5 = undisplaced skin. */
    height?: string
    /** Metres from black to white of the height map; required with `height`. */
    heightAmplitude?: number
    /** Blood in the B channel, or a gray image; linear, 128 of 255 = no change. */
    blood?: string
    /** Optical depth of green at 255, 0..2; required with `blood`. */
    bloodAmplitude?: number
  }[]
  areas: {
    name: string
    /** Gray image; `areas/NAME.png` by default. */
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
  /** Side of the packed areas in texels; default 128. */
  areaSize?: number
  /** URL of the strokes document; for `furrow pack`. */
  strokes?: string
  /** Corrections to the recognised blendshapes, unchecked; for `furrow pack`. */
  shapes?: unknown
}

/** The optional maps of a layer. */
const MAPS = ['baseColor', 'roughness', 'occlusion', 'height', 'blood'] as const

/** Maximum length of a URL. */
const MAX_URL_LENGTH = 2048

/**
 * Reads `wrinkles.json`. Drivers are returned unchecked.
 *
 * @param json result of `JSON.parse`.
 * @param convention default for areas without one.
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
  if (json.normalScale !== undefined) {
    layer.normalScale = reader.number(json.normalScale, `${at}.normalScale`, -MAX_NUMBER, MAX_NUMBER, '')
  }
  if (json.occlusionStrength !== undefined) {
    layer.occlusionStrength = reader.number(json.occlusionStrength, `${at}.occlusionStrength`, 0, 1, '')
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
