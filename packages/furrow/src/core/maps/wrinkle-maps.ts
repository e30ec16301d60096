import { MAX_BLOOD_AMPLITUDE } from '../blood.ts'
import { type JsonReader, orDefault } from '../json.ts'
import { MAX_AREAS, MAX_LAYERS, MAX_NUMBER, MAX_SLICES } from '../limits.ts'
import type { Combine, LayerKind } from '../types.ts'

/** A glTF texture info. Fields that glTF defines, such as `texCoord`, may also be present. */
export interface TextureReference {
  /** Index of the texture in the file. */
  index: number
  /** Index of a slice in a KTX 2 texture array; absent for an image that is not an array. */
  slice?: number
}

/** A layer in the JSON of the glTF extension FURROW_wrinkle_maps, with defaults filled in. */
export interface WrinkleMapsLayer {
  name: string
  kind: LayerKind
  /** Tangent-space normals, linear, +Y towards smaller v; `scale` multiplies x and y. */
  normalTexture: TextureReference & { scale: number }
  /** Base colour of fully wrinkled skin, sRGB. */
  baseColorTexture?: TextureReference
  /** Roughness in G, linear, as in glTF's metallic-roughness texture. */
  roughnessTexture?: TextureReference
  /** Occlusion in R, linear; `strength` has the same meaning as in glTF's occlusion texture. */
  occlusionTexture?: TextureReference & { strength: number }
  /** Height in R, linear, 0.5 = undisplaced skin; `amplitude` is the height difference between black and white, in metres. */
  heightTexture?: TextureReference & { amplitude: number }
  /** Change of blood in B, linear; byte 128 = no change. `amplitude` is the optical depth for green light that byte 255 adds. */
  bloodTexture?: TextureReference & { amplitude: number }
  /** Onset in G, linear, see `onsetInfluence`; `strength` 0 turns the map off. */
  onsetTexture?: TextureReference & { strength: number }
}

/** An area of influence in the extension's JSON, with defaults filled in. */
export interface WrinkleMapsArea {
  name: string
  /** Index of the layer whose wrinkles the area shows. */
  layer: number
  /** Weights, linear, 1 = wrinkles fully visible. */
  texture: TextureReference
  /** Channel that stores the weights, 0 = R to 3 = A. */
  channel: number
  combine: Combine
  /** Resting activation, 0..1, to which drivers add. */
  activation: number
}

export interface MapsAndAreas {
  layers: WrinkleMapsLayer[]
  areas: WrinkleMapsArea[]
}

/**
 * Reads and checks the extension's JSON. Drivers are returned unchecked.
 *
 * @param json value of `material.extensions.FURROW_wrinkle_maps`, of any type.
 * @param textureCount number of textures in the file; Infinity if unknown.
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

/** Groups of slots. Slices in the slots of one group must come from the same texture array. */
const ARRAYS = [
  ['layers', ['normalTexture']],
  ['layers', ['baseColorTexture']],
  ['layers', ['roughnessTexture']],
  ['layers', ['occlusionTexture', 'bloodTexture', 'onsetTexture']],
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
  for (const slot of ['occlusionTexture', 'onsetTexture'] as const) {
    if (json[slot] === undefined) continue
    const info = texture(json[slot], `${at}.${slot}`)
    const strength = reader.number(orDefault(info.strength, 1), `${at}.${slot}.strength`, 0, 1, '')
    layer[slot] = { ...info, strength }
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
  }
  checkSharedImage(reader, layer, at)
  return layer
}

/**
 * Checks that occlusion, blood and onset are stored in the same image, so that shaders need only one sampler for them. Roughness must be
 * stored in another image than onset, because both use the G channel.
 */
function checkSharedImage(
  reader: JsonReader,
  { roughnessTexture, occlusionTexture, bloodTexture, onsetTexture }: WrinkleMapsLayer,
  at: string,
): void {
  const isSame = (a: TextureReference, b: TextureReference) => a.index === b.index && a.slice === b.slice
  const nameOf = ({ index, slice }: TextureReference) =>
    slice === undefined ? `${index}` : `${index}, slice ${slice}`
  if (occlusionTexture && bloodTexture && !isSame(occlusionTexture, bloodTexture)) {
    const remedy = 'store blood in the B channel of the occlusion image'
    reader.fail(
      `${at}.bloodTexture differs from occlusionTexture`,
      nameOf(bloodTexture),
      nameOf(occlusionTexture),
      remedy,
    )
  }
  if (!onsetTexture) return
  const other = occlusionTexture ? 'occlusion' : 'blood'
  const shared = occlusionTexture ?? bloodTexture
  if (shared && !isSame(shared, onsetTexture)) {
    const remedy = `store onset in the G channel of the ${other} image`
    reader.fail(
      `${at}.onsetTexture differs from ${other}Texture`,
      nameOf(onsetTexture),
      nameOf(shared),
      remedy,
    )
  }
  if (roughnessTexture && isSame(roughnessTexture, onsetTexture)) {
    const remedy = 'store roughness in a separate image, because both use the G channel'
    reader.fail(
      `${at}.onsetTexture is the image of roughnessTexture`,
      nameOf(onsetTexture),
      'another image',
      remedy,
    )
  }
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

/**
 * Checks that maps of one kind are either all images or all slices of the same texture array, and that nothing uses a texture array
 * without a slice index.
 */
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
        const problem = `${at} is not in the texture array of ${array!.at}`
        reader.fail(
          problem,
          index,
          `a slice of texture ${array!.index}`,
          'pack maps of one kind into one array',
        )
      }
      ;(slice === undefined ? images : arrays).set(index, at)
    }
  }
  for (const [index, at] of arrays) {
    if (!images.has(index)) continue
    reader.fail(
      `${images.get(index)} has no slice`,
      index,
      `a slice index, because ${at} has one`,
      'add `slice`',
    )
  }
}
