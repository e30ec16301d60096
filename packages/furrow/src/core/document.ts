import type { AreaConvention } from './area.ts'
import { MAX_BLOOD_AMPLITUDE } from './blood.ts'
import { type JsonReader, or } from './json.ts'
import { LARGEST, LONGEST_NAME, MAX_AREAS, MAX_IMAGE_SIDE, MAX_LAYERS, MIN_AREA_SIZE } from './limits.ts'
import type { Combine, LayerKind } from './types.ts'

/** The layers and areas of `wrinkles.json`; image URLs are relative to it. */
export interface SetDocument {
  version: 1
  /** Name of the mesh that wrinkles, or of its node; for `furrow pack`. */
  mesh?: string
  /** Name of its material; for `furrow pack`. */
  material?: string
  layers: {
    name: string
    kind: LayerKind
    /** Tangent-space normal map, linear, +Y towards smaller v; `layers/NAME/normal.png` by default. */
    normal: string
    /** Factor on x and y of the normals, 1 by default. */
    normalScale?: number
    /** Skin colour, sRGB. */
    baseColor?: string
    /** Roughness in the G channel, linear. */
    roughness?: string
    /** Occlusion in the R channel, linear. */
    occlusion?: string
    /** 0 = none, 1 = as in the map; 1 by default. */
    occlusionStrength?: number
    /** Height in the R channel, linear, 0.5 = the surface. */
    height?: string
    /** Metres from black to white of the height map; required with it. */
    heightAmplitude?: number
    /** Blood in the B channel, linear, 128 of 255 = as at rest. Gray images have it in all. */
    blood?: string
    /** Optical depth that green light gains from 128 to 255, 0..2; required with it. */
    bloodAmplitude?: number
  }[]
  areas: {
    name: string
    /** Gray image; `areas/NAME.png` by default. */
    image: string
    /** Name of its layer; the first by default. */
    layer?: string
    /** `sum` by default. */
    combine?: Combine
    /** `paper` by default. */
    convention?: AreaConvention
    /** Activation at rest, 0..1, 0 by default. */
    activation?: number
  }[]
  /** Side in texels that areas are resampled to when they are packed, 128 by default. */
  areaSize?: number
  /** The lines of the layers, a document of strokes; for `furrow pack`. */
  strokes?: string
  /** Corrections of recognised blendshapes, unchecked; for `furrow pack`. */
  shapes?: unknown
}

/** The optional maps of a layer. */
const MAPS = ['baseColor', 'roughness', 'occlusion', 'height', 'blood'] as const

/** Most characters of a URL. */
const MAX_URL_LENGTH = 2048

/**
 * Reads `wrinkles.json` except its drivers, which are returned unchecked.
 *
 * @param json anything `JSON.parse` can return.
 * @param convention of areas that do not name one.
 * @throws FurrowError that names the first field which is missing, has the wrong type or is out of range.
 */
export function readSetDocument(
  reader: JsonReader,
  json: unknown,
  convention: AreaConvention,
): SetDocument & { drivers: unknown } {
  const root = reader.object(json, 'the document')
  if (or(root.version, 1) !== 1)
    reader.fail('unknown version', root.version, '1', 'write it in version 1 of the format')
  const layers = reader
    .array(root.layers, 'layers', 1, MAX_LAYERS)
    .map((item, i) => readLayer(reader, item, `layers[${i}]`))
  const areas = reader
    .array(root.areas, 'areas', 1, MAX_AREAS)
    .map((item, i) => readArea(reader, item, `areas[${i}]`, convention))
  const names = (['mesh', 'material'] as const).filter((field) => root[field] !== undefined)
  return {
    version: 1,
    ...Object.fromEntries(names.map((field) => [field, reader.text(root[field], field, LONGEST_NAME)])),
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
  const usual = `layers/${encodeURIComponent(name)}/normal.png`
  const layer: SetDocument['layers'][number] = {
    name,
    kind: reader.choice(or(json.kind, 'replace'), `${at}.kind`, ['replace', 'detail']),
    normal: reader.text(or(json.normal, usual), `${at}.normal`, MAX_URL_LENGTH),
  }
  for (const map of MAPS) {
    if (json[map] !== undefined) layer[map] = reader.text(json[map], `${at}.${map}`, MAX_URL_LENGTH)
  }
  if (json.normalScale !== undefined) {
    layer.normalScale = reader.number(json.normalScale, `${at}.normalScale`, -LARGEST, LARGEST, '')
  }
  if (json.occlusionStrength !== undefined) {
    layer.occlusionStrength = reader.number(json.occlusionStrength, `${at}.occlusionStrength`, 0, 1, '')
  }
  if (layer.height !== undefined || json.heightAmplitude !== undefined) {
    layer.heightAmplitude = reader.number(json.heightAmplitude, `${at}.heightAmplitude`, 0, LARGEST, 'metres')
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
  const usual = `areas/${encodeURIComponent(name)}.png`
  return {
    name,
    image: reader.text(or(area.image, usual), `${at}.image`, MAX_URL_LENGTH),
    ...(area.layer !== undefined && { layer: reader.name(area.layer, `${at}.layer`) }),
    combine: reader.choice<Combine>(or(area.combine, 'sum'), `${at}.combine`, ['sum', 'max']),
    convention: reader.choice<AreaConvention>(or(area.convention, convention), `${at}.convention`, [
      'paper',
      'weight',
    ]),
    ...(area.activation !== undefined && {
      activation: reader.number(area.activation, `${at}.activation`, 0, 1, ''),
    }),
  }
}
