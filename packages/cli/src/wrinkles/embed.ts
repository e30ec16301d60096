import { parseWrinkleMaps, WRINKLE_MAPS, type WrinkleDriver, type WrinkleSetDocument } from 'furrow'
import type { Glb, GltfJson } from './glb-file.ts'
import { ViewAdder } from './view-adder.ts'

/** An encoded image that goes into the file. */
export interface FileImage {
  name: string
  mimeType: string
  /** Images with the same bytes are stored once. */
  bytes: Uint8Array
  /** Which slice of it is meant, where it is an array. */
  slice?: number
}

/** One layer with its images; numbers as in the extension. */
export interface LayerImages {
  name: string
  kind: WrinkleSetDocument['layers'][number]['kind']
  normal: FileImage
  normalScale?: number
  baseColor?: FileImage
  roughness?: FileImage
  occlusion?: FileImage
  occlusionStrength?: number
  height?: FileImage
  heightAmplitude?: number
}

/** One area and its place in an image that others may share. */
export interface AreaPlace {
  name: string
  image: FileImage
  channel: number
  /** Index of its layer. */
  layer: number
  combine?: WrinkleSetDocument['areas'][number]['combine']
  activation?: number
}

export interface PackedWrinkles {
  layers: LayerImages[]
  areas: AreaPlace[]
  drivers: WrinkleDriver[]
}

const CLAMP_TO_EDGE = 33071

/** The extension for KTX 2 images. */
export const BASIS = 'KHR_texture_basisu'

export function usesBasis({ textures = [] }: GltfJson): boolean {
  return textures.some(({ extensions }) => extensions?.[BASIS] !== undefined)
}

/**
 * Puts wrinkles on a material: images at the end of the binary part, textures at the end of the list, so that no
 * index of anything else changes.
 *
 * @param glb changed in place, but for its binary part, which is replaced.
 * @throws FurrowError when the result is not valid.
 */
export function embedWrinkles(glb: Glb, materialIndex: number, wrinkles: PackedWrinkles, who: string): void {
  const { json } = glb
  const material = json.materials![materialIndex]
  const normal = material.normalTexture
  // Wrinkles lie where the skin's own normals lie; tools that prune texture coordinates see it from this.
  const beside = normal?.texCoord ? { texCoord: normal.texCoord } : {}
  const skinSampler = json.textures?.[normal?.index ?? -1]?.sampler
  const adder = new TextureAdder(glb)
  const texture = (image: FileImage | undefined, more: object = {}) =>
    image && { ...adder.place(image, skinSampler), ...beside, ...more }

  const layers = wrinkles.layers.map((layer) => ({
    name: layer.name,
    ...(layer.kind !== 'replace' && { kind: layer.kind }),
    normalTexture: texture(layer.normal, unlessDefault('scale', layer.normalScale, 1)),
    baseColorTexture: texture(layer.baseColor),
    roughnessTexture: texture(layer.roughness),
    occlusionTexture: texture(layer.occlusion, unlessDefault('strength', layer.occlusionStrength, 1)),
    heightTexture: texture(layer.height, { amplitude: layer.heightAmplitude }),
  }))
  const areas = wrinkles.areas.map((area) => ({
    name: area.name,
    ...unlessDefault('layer', area.layer, 0),
    texture: { ...adder.place(area.image, adder.clampedSampler()), ...beside },
    ...unlessDefault('channel', area.channel, 0),
    ...unlessDefault('combine', area.combine, 'sum'),
    ...unlessDefault('activation', area.activation, 0),
  }))
  const { drivers } = wrinkles
  // Through JSON once, so that fields without a value are gone.
  const extension = JSON.parse(JSON.stringify({ layers, areas, ...(drivers.length > 0 && { drivers }) }))
  parseWrinkleMaps(extension, json.textures?.length ?? 0, who)
  material.extensions = { ...material.extensions, [WRINKLE_MAPS]: extension }
  const basis = usesBasis(json) ? [BASIS] : []
  json.extensionsUsed = [...new Set([...(json.extensionsUsed ?? []), WRINKLE_MAPS, ...basis])]
  adder.finish()
}

function unlessDefault(field: string, value: unknown, usual: unknown): object {
  return value === undefined || value === usual ? {} : { [field]: value }
}

/** Adds textures to a file; an image that comes twice is stored once. */
class TextureAdder {
  readonly #json: GltfJson
  readonly #views: ViewAdder
  readonly #added = new Map<Uint8Array, number>()

  constructor(glb: Glb) {
    this.#json = glb.json
    this.#views = new ViewAdder(glb)
    glb.json.images ??= []
    glb.json.textures ??= []
  }

  /** @returns what a texture info says of it. */
  place(image: FileImage, sampler: number | undefined): { index: number; slice?: number } {
    const index = this.#added.get(image.bytes) ?? this.#add(image, sampler)
    return { index, ...(image.slice !== undefined && { slice: image.slice }) }
  }

  #add({ name, mimeType, bytes, slice }: FileImage, sampler: number | undefined): number {
    const { images, textures } = this.#json
    const source = images!.push({ name, mimeType, bufferView: this.#views.add(bytes) }) - 1
    const image = slice === undefined ? { source } : { extensions: { [BASIS]: { source } } }
    const index = textures!.push({ name, ...(sampler !== undefined && { sampler }), ...image }) - 1
    this.#added.set(bytes, index)
    return index
  }

  /** Areas end at the edges of their image. */
  clampedSampler(): number {
    this.#json.samplers ??= []
    const clamped = { wrapS: CLAMP_TO_EDGE, wrapT: CLAMP_TO_EDGE }
    const found = this.#json.samplers.findIndex((item) => JSON.stringify(item) === JSON.stringify(clamped))
    return found >= 0 ? found : this.#json.samplers.push(clamped) - 1
  }

  finish(): void {
    this.#views.finish()
  }
}
