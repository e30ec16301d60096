import { MAX_BLOOD_AMPLITUDE } from '../blood.ts'
import { type JsonReader, or } from '../json.ts'
import { LARGEST, MAX_AREAS, MAX_LAYERS, MAX_SLICES } from '../limits.ts'
import type { Combine, LayerKind } from '../types.ts'

/** A glTF texture info: a texture by its index, with whatever other fields glTF allows. */
export interface TextureReference {
  /** Index among the file's textures. */
  index: number
  /** Slice of a KTX 2 texture array; absent for an ordinary image. */
  slice?: number
}

/** One layer of the extension's JSON, defaults filled in. */
export interface WrinkleMapsLayer {
  name: string
  kind: LayerKind
  /** Tangent-space normals, linear, +Y towards smaller v; `scale` multiplies x and y. */
  normalTexture: TextureReference & { scale: number }
  /** Skin colour fully wrinkled, sRGB. */
  baseColorTexture?: TextureReference
  /** Roughness in G, linear, as in glTF's metallic-roughness texture. */
  roughnessTexture?: TextureReference
  /** Occlusion in R, linear; `strength` as in glTF's occlusion texture. */
  occlusionTexture?: TextureReference & { strength: number }
  /** Height in R, linear, 0.5 = the surface; `amplitude` is the metres from black to white. */
  heightTexture?: TextureReference & { amplitude: number }
  /** Blood in B, linear, 128 of 255 = as at rest; `amplitude` is what green light loses from there to 255, as an optical depth. */
  bloodTexture?: TextureReference & { amplitude: number }
}

/** One area of the extension's JSON, defaults filled in. */
export interface WrinkleMapsArea {
  name: string
  /** Index of the layer whose wrinkles it shows. */
  layer: number
  /** Weights, linear, 1 = fully visible; the extension has no other convention. */
  texture: TextureReference
  /** Channel of the texture, 0 = R to 3 = A: one image may hold four areas. */
  channel: number
  combine: Combine
  /** Activation at rest, 0..1. */
  activation: number
}

/** The layers and areas of the extension's JSON, checked and with defaults filled in. */
export interface MapsAndAreas {
  layers: WrinkleMapsLayer[]
  areas: WrinkleMapsArea[]
}

/**
 * Reads the extension's JSON except its drivers, which are returned unchecked.
 *
 * @param json the value of `material.extensions.FURROW_wrinkle_maps`, of any type.
 * @param textureCount number of textures in the file, to check indices against; Infinity if unknown.
 * @throws FurrowError that names the first field which is missing, has the wrong type or is out of range.
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

/** Slots of layers and areas whose maps are in one array, if in any. */
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
    reader.number(value, `${at}.${path}`, low, LARGEST, '')
  const normal = texture(json.normalTexture, `${at}.normalTexture`)
  const layer: WrinkleMapsLayer = {
    name: reader.name(json.name, `${at}.name`),
    kind: reader.choice(or(json.kind, 'replace'), `${at}.kind`, ['replace', 'detail']),
    normalTexture: { ...normal, scale: number(or(normal.scale, 1), 'normalTexture.scale', -LARGEST) },
  }
  for (const slot of ['baseColorTexture', 'roughnessTexture'] as const) {
    if (json[slot] !== undefined) layer[slot] = texture(json[slot], `${at}.${slot}`)
  }
  if (json.occlusionTexture !== undefined) {
    const info = texture(json.occlusionTexture, `${at}.occlusionTexture`)
    const strength = reader.number(or(info.strength, 1), `${at}.occlusionTexture.strength`, 0, 1, '')
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

/** Blood is the third channel of the occlusion's image, so that no shader needs another sampler for it. */
function checkBlood(
  reader: JsonReader,
  blood: TextureReference,
  occlusion: TextureReference | undefined,
  at: string,
): void {
  if (!occlusion || (blood.index === occlusion.index && blood.slice === occlusion.slice)) return
  const nameOf = ({ index, slice }: TextureReference) =>
    slice === undefined ? `${index}` : `${index}, slice ${slice}`
  const remedy = 'put it into the B channel of that image'
  reader.fail(`${at}.bloodTexture is not that of the occlusion`, nameOf(blood), nameOf(occlusion), remedy)
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
    layer: reader.integer(or(json.layer, 0), `${at}.layer`, 0, layerCount - 1),
    texture: texture(json.texture, `${at}.texture`),
    channel: reader.integer(or(json.channel, 0), `${at}.channel`, 0, 3),
    combine: reader.choice(or(json.combine, 'sum'), `${at}.combine`, ['sum', 'max']),
    activation: reader.number(or(json.activation, 0), `${at}.activation`, 0, 1, ''),
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

/** Maps of one kind are either all images, or all slices of one array that no ordinary map uses. */
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
        const limit = `slices of texture ${array!.index}, as ${array!.at}, or no slices at all`
        reader.fail(`${at} is not in the same array`, index, limit, 'put all of them into one array')
      }
      ;(slice === undefined ? images : arrays).set(index, at)
    }
  }
  for (const [index, at] of arrays) {
    if (!images.has(index)) continue
    reader.fail(`${images.get(index)} has no slice`, index, `a slice, as ${at}`, 'name its slice')
  }
}
