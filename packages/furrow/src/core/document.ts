import type { AreaConvention } from './area.ts'
import type { JsonReader } from './json.ts'
import { LARGEST, MAX_AREAS, MAX_IMAGE_SIDE, MAX_LAYERS } from './limits.ts'
import type { Combine, LayerKind } from './types.ts'

/** The layers and areas of `wrinkles.json`; images are files, their addresses relative to it. */
export interface SetDocument {
  version: 1
  layers: {
    name: string
    kind: LayerKind
    /** Tangent-space normal map. */
    normal: string
    /** Multiplies x and y of the normals; 1 when absent. */
    normalScale?: number
    baseColor?: string
    /** Its G channel counts. */
    roughness?: string
    /** Its R channel counts. */
    occlusion?: string
    /** 1 when absent. */
    occlusionStrength?: number
    /** Its R channel counts, 0.5 = the surface. */
    height?: string
    /** Metres from black to white of the height map; comes with it. */
    heightAmplitude?: number
  }[]
  areas: {
    name: string
    /** Gray image. */
    image: string
    layer?: string
    combine?: Combine
    convention?: AreaConvention
    /** Activation at rest, 0..1; 0 when absent. */
    activation?: number
  }[]
  /** Side that areas are resampled to when they are packed; 128 when absent. */
  areaSize?: number
}

/** The optional maps of a layer. */
const MAPS = ['baseColor', 'roughness', 'occlusion', 'height'] as const

/** Longest address of an image. */
const LONGEST_ADDRESS = 2048

const SMALLEST_AREA = 2

/**
 * Reads `wrinkles.json`, but for its drivers, which are returned as they are.
 *
 * @param json anything `JSON.parse` can return.
 * @param convention of areas that do not name one.
 * @throws FurrowError that names the first field which is missing or has the wrong type.
 */
export function readSetDocument(
  reader: JsonReader,
  json: unknown,
  convention: AreaConvention,
): SetDocument & { drivers: unknown } {
  const root = reader.object(json, 'the document')
  if (root.version !== 1)
    reader.fail('unknown version', root.version, '1', 'write it in version 1 of the format')
  const layers = reader
    .array(root.layers, 'layers', 1, MAX_LAYERS)
    .map((item, i) => readLayer(reader, item, `layers[${i}]`))
  const areas = reader
    .array(root.areas, 'areas', 1, MAX_AREAS)
    .map((item, i) => readArea(reader, item, `areas[${i}]`, convention))
  return {
    version: 1,
    layers,
    areas,
    drivers: root.drivers,
    ...(root.areaSize !== undefined && {
      areaSize: reader.integer(root.areaSize, 'areaSize', SMALLEST_AREA, MAX_IMAGE_SIDE),
    }),
  }
}

function readLayer(reader: JsonReader, item: unknown, at: string): SetDocument['layers'][number] {
  const json = reader.object(item, at)
  const layer: SetDocument['layers'][number] = {
    name: reader.text(json.name, `${at}.name`),
    kind: reader.choice(json.kind ?? 'replace', `${at}.kind`, ['replace', 'detail']),
    normal: reader.text(json.normal, `${at}.normal`, LONGEST_ADDRESS),
  }
  for (const map of MAPS) {
    if (json[map] !== undefined) layer[map] = reader.text(json[map], `${at}.${map}`, LONGEST_ADDRESS)
  }
  if (json.normalScale !== undefined) {
    layer.normalScale = reader.number(json.normalScale, `${at}.normalScale`, -LARGEST, LARGEST, '')
  }
  if (json.occlusionStrength !== undefined) {
    layer.occlusionStrength = reader.number(json.occlusionStrength, `${at}.occlusionStrength`, 0, 1, '')
  }
  if (layer.height !== undefined) {
    layer.heightAmplitude = reader.number(json.heightAmplitude, `${at}.heightAmplitude`, 0, LARGEST, 'metres')
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
  return {
    name: reader.text(area.name, `${at}.name`),
    image: reader.text(area.image, `${at}.image`, LONGEST_ADDRESS),
    ...(area.layer !== undefined && { layer: reader.text(area.layer, `${at}.layer`) }),
    combine: reader.choice<Combine>(area.combine ?? 'sum', `${at}.combine`, ['sum', 'max']),
    convention: reader.choice<AreaConvention>(area.convention ?? convention, `${at}.convention`, [
      'paper',
      'weight',
    ]),
    ...(area.activation !== undefined && {
      activation: reader.number(area.activation, `${at}.activation`, 0, 1, ''),
    }),
  }
}
