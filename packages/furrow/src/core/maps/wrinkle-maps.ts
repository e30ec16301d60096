import { MAX_BLOOD_AMPLITUDE } from '../blood.ts'
import { type JsonReader, orDefault } from '../json.ts'
import { MAX_AREAS, MAX_LAYERS, MAX_NUMBER, MAX_SLICES } from '../limits.ts'
import type { Combine, LayerKind } from '../types.ts'

/** A glTF texture info; other fields of glTF may be present. */
export interface TextureReference {
  /** Index of the texture in the file. */
  index: number
  /** Slice of a KTX 2 texture array; absent for an ordinary image. */
  slice?: number
}

/** A layer in the extension's JSON, with defaults filled in. */
export interface WrinkleMapsLayer {
  name: string
  kind: LayerKind
  /** Tangent-space normals, linear, +Y towards smaller v; `scale` multiplies x and y. */
  normalTexture: TextureReference & { scale: number }
  /** Colour of fully wrinkled skin, sRGB. */
  baseColorTexture?: TextureReference
  /** Roughness in G, linear, as in glTF's metallic-roughness texture. */
  roughnessTexture?: TextureReference
  /** Occlusion in R, linear; `strength` as in glTF's occlusion texture. */
  occlusionTexture?: TextureReference & { strength: number }
  /** Height in R, linear, 0.5 = undisplaced skin; `amplitude` is the range from black to white in metres. */
  heightTexture?: TextureReference & { amplitude: number }
  /** Blood in B, linear, 128 of 255 = no change; `amplitude` is the optical depth of green at 255. */
  bloodTexture?: TextureReference & { amplitude: number }
}

/** An area in the extension's JSON, with defaults filled in. */
export interface WrinkleMapsArea {
  name: string
  /** Index of the layer. */
  layer: number
  /** Weights, linear, 1 = fully visible. */
  texture: TextureReference
  /** Channel of the texture, 0 = R to 3 = A; an image can hold four areas. */
  channel: number
  combine: Combine
  /** Resting activation, 0..1. */
  activation: number
}

/** Layers and areas in the extension's JSON, checked and with defaults filled in. */
export interface MapsAndAreas {
  layers: WrinkleMapsLayer[]
  areas: WrinkleMapsArea[]
}

/**
 * Reads the extension's JSON. Drivers are returned unchecked.
 *
 * @param json value of `material.extensions.FURROW_wrinkle_maps`, of any type.
 * @param textureCount number of textures in the file, to check indices; Infinity if unknown.
 * @throws FurrowError naming the first field that is missing, has the wrong type or is out of range.
 */
export function readMaps(
  reader: JsonReader,
  json: unknown,
  textureCount: number,
): MapsAndAreas & { drivers: unknown } {
  const root = reader.object(json, 'the extension')
  const texture = textureReader(reader, textureCount)
  const layers = reader
    .array(root.layers, 'layers', 1, MAX_LAYERS)
    .map((item, i) => readLayer(reader, texture, item, `layers[${i}]`))
  const areas = reader
    .array(root.areas, 'areas', 1, MAX_AREAS)
    .map((item, i) => readArea(reader, texture, item, `areas[${i}]`, layers.length))
  checkNames(reader, layers, 'layers')
  checkNames(reader, areas, 'areas')
  checkSlices(reader, layers, areas)
  return { layers, areas, drivers: root.drivers }
}

/** Slots whose maps share one texture array, if they are slices. */
const ARRAYS = [
  ['layers', ['normalTexture']],
  ['layers', ['baseColorTexture']],
  ['layers', ['roughnessTexture']],
  ['layers', ['occlusionTexture', 'bloodTexture']],
  ['layers', ['heightTexture']],
  ['areas', ['texture']],
] as const

type ReadTexture = (value: unknown, path: string) => Record<string, unknown> & TextureReference

function textureReader(reader: JsonReader, count: number): ReadTexture {
  return (value, path) => {
    const info = reader.object(value, path)
    const index = reader.integer(info.index, `${path}.index`, 0, count - 1)
    if (info.slice === undefined) return { ...info, index } as ReturnType<ReadTexture>
    return { ...info, index, slice: reader.integer(info.slice, `${path}.slice`, 0, MAX_SLICES - 1) }
  }
}

function readLayer(reader: JsonReader, texture: ReadTexture, item: unknown, at: string): WrinkleMapsLayer {
  const json = reader.object(item, at)
  const number = (value: unknown, path: string, low: number) =>
    reader.number(value, `${at}.${path}`, low, MAX_NUMBER, '')
  const normal = texture(json.normalTexture, `${at}.normalTexture`)
  const layer: WrinkleMapsLayer = {
    name: reader.name(json.name, `${at}.name`),
    kind: reader.choice(orDefault(json.kind, 'replace'), `${at}.kind`, ['replace', 'detail']),
    normalTexture: {
      ...normal,
      scale: number(orDefault(normal.scale, 1), 'normalTexture.scale', -MAX_NUMBER),
    },
  }
  for (const slot of ['baseColorTexture', 'roughnessTexture'] as const) {
    if (json[slot] !== undefined) layer[slot] = texture(json[slot], `${at}.${slot}`)
  }
  if (json.occlusionTexture !== undefined) {
    const info = texture(json.occlusionTexture, `${at}.occlusionTexture`)
    const strength = reader.number(orDefault(info.strength, 1), `${at}.occlusionTexture.strength`, 0, 1, '')
    layer.occlusionTexture = { ...info, strength }
  }
  if (json.heightTexture !== undefined) {
    const info = texture(json.heightTexture, `${at}.heightTexture`)
    layer.heightTexture = { ...info, amplitude: number(info.amplitude, 'heightTexture.amplitude', 0) }
  }
  if (json.bloodTexture !== undefined) {
    const info = texture(json.bloodTexture, `${at}.bloodTexture`)
    const field = `${at}.bloodTexture.amplitude`
    layer.bloodTexture = {
      ...info,
      amplitude: reader.number(info.amplitude, field, 0, MAX_BLOOD_AMPLITUDE, ''),
    }
    checkBlood(reader, layer.bloodTexture, layer.occlusionTexture, at)
  }
  return layer
}

/** Checks that blood shares the image of occlusion, so that shaders need no extra sampler. */
function checkBlood(
  reader: JsonReader,
  blood: TextureReference,
  occlusion: TextureReference | undefined,
  at: string,
): void {
  if (!occlusion || (blood.index === occlusion.index && blood.slice === occlusion.slice)) return
  const nameOf = ({ index, slice }: TextureReference) =>
    slice === undefined ? `${index}` : `${index}, slice ${slice}`
  const remedy = 'store blood in the B channel of the occlusion image'
  reader.fail(`${at}.bloodTexture differs from occlusionTexture`, nameOf(blood), nameOf(occlusion), remedy)
}

function readArea(
  reader: JsonReader,
  texture: ReadTexture,
  item: unknown,
  at: string,
  layerCount: number,
): WrinkleMapsArea {
  const json = reader.object(item, at)
  return {
    name: reader.name(json.name, `${at}.name`),
    layer: reader.integer(orDefault(json.layer, 0), `${at}.layer`, 0, layerCount - 1),
    texture: texture(json.texture, `${at}.texture`),
    channel: reader.integer(orDefault(json.channel, 0), `${at}.channel`, 0, 3),
    combine: reader.choice(orDefault(json.combine, 'sum'), `${at}.combine`, ['sum', 'max']),
    activation: reader.number(orDefault(json.activation, 0), `${at}.activation`, 0, 1, ''),
  }
}

function checkNames(reader: JsonReader, named: readonly { name: string }[], list: string): void {
  const seen = new Set<string>()
  for (const [i, { name }] of named.entries()) {
    if (seen.has(name))
      reader.fail(`${list}[${i}].name is taken`, name, undefined, 'give each a distinct name')
    seen.add(name)
  }
}

/** Checks that maps of one kind are all images, or all slices of one array without other users. */
function checkSlices(reader: JsonReader, layers: WrinkleMapsLayer[], areas: WrinkleMapsArea[]): void {
  const arrays = new Map<number, string>()
  const images = new Map<number, string>()
  for (const [list, slots] of ARRAYS) {
    const owners: readonly object[] = list === 'areas' ? areas : layers
    const found = owners.flatMap((owner, i) =>
      slots.flatMap((slot) => {
        const info = (owner as Partial<Record<typeof slot, TextureReference>>)[slot]
        return info ? [{ ...info, at: `${list}[${i}].${slot}` }] : []
      }),
    )
    const array = found.find(({ slice }) => slice !== undefined)
    for (const { index, slice, at } of found) {
      if ((slice !== undefined) !== (array !== undefined) || (array && index !== array.index)) {
        const limit = `slices of texture ${array!.index}, as ${array!.at}, or no slices`
        reader.fail(`${at} is in another texture array`, index, limit, 'pack maps of one kind into one array')
      }
      ;(slice === undefined ? images : arrays).set(index, at)
    }
  }
  for (const [index, at] of arrays) {
    if (!images.has(index)) continue
    reader.fail(`${images.get(index)} has no slice`, index, `a slice, as ${at}`, 'add `slice`')
  }
}
