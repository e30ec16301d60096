import type { WrinkleDriver, WrinkleSetDocument } from 'furrow'
import { parseWrinkleMaps, type ShapeCorrection, WRINKLE_MAPS } from 'furrow/internal'
import { BufferViewWriter } from '../gltf/buffer-view-writer.ts'
import type { Glb } from '../gltf/glb.ts'
import type { GltfJson } from '../json/gltf-json.ts'
import type { StoredStrokes } from '../wrinkles/strokes.ts'
import { FLAT_NORMAL, quantisedCoordinates } from './flat-normal.ts'

/** Encoded image to store in a glTF file. */
export interface FileImage {
  name: string
  mimeType: string
  /** File content. Images with the same array of bytes are stored once. */
  bytes: Uint8Array
  /** Index of a slice, if the image is a texture array. */
  slice?: number
}

/** A layer with its encoded maps. Numbers have the units of the extension FURROW_wrinkle_maps. */
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
  /** Image with blood in the blue channel. The same image as `occlusion` if the layer has an occlusion map. */
  blood?: FileImage
  bloodAmplitude?: number
  /** Image with onset in the green channel. The same image as `occlusion` and `blood`, if the layer has these maps. */
  onset?: FileImage
  onsetStrength?: number
}

/** An area with its image and channel. Several areas can share an image. */
export interface PackedArea {
  name: string
  image: FileImage
  /** 0 = R, 1 = G, 2 = B, 3 = A. */
  channel: number
  layer: number
  combine?: WrinkleSetDocument['areas'][number]['combine']
  activation?: number
}

/** Layers, areas and drivers with their images encoded. */
export interface PackedWrinkles {
  layers: LayerImages[]
  areas: PackedArea[]
  drivers: WrinkleDriver[]
  strokes?: StoredStrokes
  /** ARKit shapes that the user assigned to blendshapes. They override the automatic recognition. */
  shapes?: readonly ShapeCorrection[] | undefined
}

const CLAMP_TO_EDGE = 33071

export const KTX2_EXTENSION = 'KHR_texture_basisu'

export function usesKtx2({ textures = [] }: GltfJson): boolean {
  return textures.some(({ extensions }) => extensions?.[KTX2_EXTENSION] !== undefined)
}

/**
 * Adds wrinkles to a material. Appends images, textures and buffer views at the end of their lists, so that existing
 * indices stay valid.
 *
 * @param glb changed in place. Its binary chunk is replaced.
 * @throws FurrowError if the resulting extension is not valid.
 */
export function embedWrinkles(glb: Glb, materialIndex: number, wrinkles: PackedWrinkles, who: string): void {
  const { json } = glb
  const material = json.materials![materialIndex]
  const textures = new TextureWriter(glb)
  const quantised = quantisedCoordinates(json, materialIndex)
  if (quantised) {
    const image = { name: 'flat normal', mimeType: 'image/png', bytes: FLAT_NORMAL }
    const sampler = json.textures?.[quantised.index]?.sampler
    material.normalTexture = { ...quantised, ...textures.add(image, sampler) }
  }
  const normal = material.normalTexture
  // Furrow ignores `texCoord`: wrinkles use the texture coordinates of the skin's normal map. It is written so that
  // tools do not remove these coordinates as unused attributes.
  const texCoord = normal?.texCoord ? { texCoord: normal.texCoord } : {}
  const skinSampler = json.textures?.[normal?.index ?? -1]?.sampler
  const textureInfo = (image: FileImage | undefined, more: object = {}) =>
    image && { ...textures.add(image, skinSampler), ...texCoord, ...more }

  const layers = wrinkles.layers.map((layer) => ({
    name: layer.name,
    ...(layer.kind !== 'replace' && { kind: layer.kind }),
    normalTexture: textureInfo(layer.normal, omitDefault('scale', layer.normalScale, 1)),
    baseColorTexture: textureInfo(layer.baseColor),
    roughnessTexture: textureInfo(layer.roughness),
    occlusionTexture: textureInfo(layer.occlusion, omitDefault('strength', layer.occlusionStrength, 1)),
    heightTexture: textureInfo(layer.height, { amplitude: layer.heightAmplitude }),
    bloodTexture: textureInfo(layer.blood, { amplitude: layer.bloodAmplitude }),
    onsetTexture: textureInfo(layer.onset, omitDefault('strength', layer.onsetStrength, 1)),
  }))
  const areas = wrinkles.areas.map((area) => ({
    name: area.name,
    ...omitDefault('layer', area.layer, 0),
    texture: { ...textures.add(area.image, textures.clampedSampler()), ...texCoord },
    ...omitDefault('channel', area.channel, 0),
    ...omitDefault('combine', area.combine, 'sum'),
    ...omitDefault('activation', area.activation, 0),
  }))
  const { drivers, strokes, shapes = [] } = wrinkles
  // The round trip drops undefined fields.
  const extension = JSON.parse(
    JSON.stringify({
      layers,
      areas,
      ...(drivers.length > 0 && { drivers }),
      strokes,
      ...(shapes.length > 0 && { shapes }),
    }),
  )
  parseWrinkleMaps(extension, json.textures?.length ?? 0, who)
  material.extensions = { ...material.extensions, [WRINKLE_MAPS]: extension }
  const ktx2 = usesKtx2(json) ? [KTX2_EXTENSION] : []
  json.extensionsUsed = [...new Set([...(json.extensionsUsed ?? []), WRINKLE_MAPS, ...ktx2])]
  textures.finish()
}

function omitDefault(field: string, value: unknown, byDefault: unknown): object {
  return value === undefined || value === byDefault ? {} : { [field]: value }
}

/** Adds textures to a file. Stores each image once. */
class TextureWriter {
  readonly #json: GltfJson
  readonly #views: BufferViewWriter
  readonly #added = new Map<Uint8Array, number>()

  constructor(glb: Glb) {
    this.#json = glb.json
    this.#views = new BufferViewWriter(glb)
    glb.json.images ??= []
    glb.json.textures ??= []
  }

  /** @returns fields of a texture info: index of the texture, and slice. */
  add(image: FileImage, sampler: number | undefined): { index: number; slice?: number } {
    const index = this.#added.get(image.bytes) ?? this.#add(image, sampler)
    return { index, ...(image.slice !== undefined && { slice: image.slice }) }
  }

  #add({ name, mimeType, bytes, slice }: FileImage, sampler: number | undefined): number {
    const { images, textures } = this.#json
    const source = images!.push({ name, mimeType, bufferView: this.#views.add(bytes) }) - 1
    const image = slice === undefined ? { source } : { extensions: { [KTX2_EXTENSION]: { source } } }
    const index = textures!.push({ name, ...(sampler !== undefined && { sampler }), ...image }) - 1
    this.#added.set(bytes, index)
    return index
  }

  /** Returns the index of a sampler that clamps to the edge. Areas must not repeat. */
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
