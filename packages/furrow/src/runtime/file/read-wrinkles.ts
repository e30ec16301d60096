import { CHANNEL, channelOf } from '../../core/channels.ts'
import type { FurrowError } from '../../core/error.ts'
import { checkDeclared, WRINKLE_MAPS } from '../../core/maps/declared.ts'
import { DecodedBytes } from '../../core/maps/decoded-bytes.ts'
import { pngHeader } from '../../core/maps/png.ts'
import type { TextureShape } from '../../core/maps/rules.ts'
import type { MapsAndAreas, TextureReference, WrinkleMapsLayer } from '../../core/maps/wrinkle-maps.ts'
import type { Area, ArraySlice, GrayImage, Layer, RgbaImage, WrinkleSet } from '../../core/types.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import { readUsualMaps } from '../../drivers/usual-maps.ts'
import { decodeBytes } from './decode-image.ts'
import { fileError } from './file-error.ts'

/** The wrinkles of a material in a file. */
export interface FileWrinkles {
  /** The same object for all faces that have the same material in the file. */
  set: WrinkleSet<ArraySlice>
  /** For `addDrivers`. */
  drivers: WrinkleDriver[]
}

/** A glTF file, as far as its wrinkles are read from it. */
export interface WrinkledFile {
  // biome-ignore lint/suspicious/noExplicitAny: JSON of any shape
  readonly json: any
  /**
   * The bytes of an image of the file, by its index; undefined where there is no such image.
   *
   * @param who names the texture in errors.
   * @throws FurrowError when it cannot be fetched.
   */
  readBytes(image: unknown, who: string): Promise<Uint8Array<ArrayBuffer> | undefined>
  /** Whether KTX 2 is read where a texture has another image too. */
  readonly prefersArrays: boolean
  /**
   * Loads a KTX 2 image or array.
   *
   * @param index of its texture.
   * @param check throws where it may not be decoded.
   * @throws FurrowError when it cannot be read.
   */
  loadArray(index: number, use: ArrayUse, check: (shape: TextureShape) => void): Promise<FileArray>
  /** Joins the arrays of each kind of map into one. */
  joinArrays(set: WrinkleSet<ArraySlice>): Promise<WrinkleSet<ArraySlice>>
}

/** What an array is used for, which decides its format on the GPU. */
export type ArrayUse = 'areas' | 'maps' | 'colours'

/** A KTX 2 image or array of a file: a texture of the engine, and what its header says. */
interface FileArray {
  array: object
  header: TextureShape
}

const UNREADABLE = 'the wrinkles cannot be read'

/** How the wrinkles of materials are read. */
export interface ReadOptions {
  /** Is told of each malformed driver, which is then left out; by default it is thrown. */
  onFault?: (fault: FurrowError) => void
  /** Whether the layers' heights are read now; by default their layers have `readHeight`, see `RaisedLayer`. */
  withHeights?: boolean
}

/**
 * Reads the wrinkles of materials, of each once.
 *
 * @returns a function of a material's index, which throws FurrowError when the extension is malformed or an image cannot be read.
 */
export function wrinkleReader(
  file: WrinkledFile,
  options: ReadOptions = {},
): (material: number) => Promise<FileWrinkles> {
  const known = new Map<number, Promise<FileWrinkles>>()
  const decoded = new DecodedBytes()
  const read = async (material: number): Promise<FileWrinkles> => {
    const { textures } = file.json
    const count = Array.isArray(textures) ? textures.length : 0
    try {
      const json = extensionOf(material, file)
      const maps = readUsualMaps(json, count) ?? (await parseMaps(json, count, options.onFault))
      return { set: await readSet(maps, file, decoded, options), drivers: maps.drivers }
    } catch (error) {
      throw fileError(error, WRINKLE_MAPS, UNREADABLE)
    }
  }
  return (material) => once(known, material, () => read(material))
}

/** Begins to fetch what reads a file that is out of the usual, so that it arrives while the rest is loaded. */
export function prefetchParser({ json }: Pick<WrinkledFile, 'json'>): void {
  const { materials } = json
  if (!Array.isArray(materials)) return
  const all = materials.flatMap((material) => material?.extensions?.[WRINKLE_MAPS] ?? [])
  if (all.some((maps) => !readUsualMaps(maps, Infinity))) importParser().catch(() => {})
}

/** Reads what is out of the usual, or says what is wrong with it. */
async function parseMaps(json: unknown, textureCount: number, onFault: ReadOptions['onFault']) {
  const parseWrinkleMaps = await importParser()
  return parseWrinkleMaps(json, textureCount, WRINKLE_MAPS, onFault)
}

/** Bundlers leave out what a module has beyond what is taken from it where it is imported. */
const importParser = async () => (await import('../../drivers/parse.ts')).parseWrinkleMaps

/** The extension's JSON of a material, malformed or not; undefined where it has none. */
export function extensionOf(material: number, { json }: Pick<WrinkledFile, 'json'>): unknown {
  return json.materials[material].extensions?.[WRINKLE_MAPS]
}

async function readSet(
  maps: MapsAndAreas,
  file: WrinkledFile,
  decoded: DecodedBytes,
  { withHeights }: ReadOptions,
): Promise<WrinkleSet<ArraySlice>> {
  checkDeclared(file.json, WRINKLE_MAPS)
  const source = new MapSource(file, decoded)
  // Everything at once: what decodes images has several threads.
  const [layers, areas] = await Promise.all([
    Promise.all(maps.layers.map((layer) => readLayer(layer, source))),
    Promise.all(
      maps.areas.map(
        async ({ name, layer, texture, channel, combine, activation }): Promise<Area<ArraySlice>> => ({
          name,
          layer: maps.layers[layer].name,
          combine,
          activation,
          weights: await source.gray(texture, channel, 'areas'),
        }),
      ),
    ),
  ])
  const set = { layers, areas }
  if (source.hasSlices || differInSize(layers)) {
    const { checkMaps } = await import('./check-maps.ts')
    await checkMaps(maps, source, file.json)
  }
  let heights: ReturnType<typeof readHeights> | undefined
  for (const [i, { heightTexture }] of maps.layers.entries()) {
    if (!heightTexture) continue
    // A source of its own: nothing else that was decoded stays in memory until heights are wanted.
    const readHeight = async () => {
      heights ??= readHeights(maps.layers, new MapSource(file, decoded))
      return (await heights)[i]!
    }
    Object.assign(layers[i], { heightAmplitude: heightTexture.amplitude })
    Object.assign(layers[i], withHeights ? { height: await readHeight() } : { readHeight })
  }
  // Most files have no KTX 2 images: what only these need is fetched when one appears.
  return source.hasSlices ? file.joinArrays(set) : set
}

/** Whether the images of some kind do; nothing else can be wrong with images that were decoded. */
function differInSize(layers: readonly Layer<ArraySlice>[]): boolean {
  return KINDS.some((kinds) => {
    const maps = layers.flatMap((layer) => kinds.map((kind) => layer[kind] as RgbaImage | undefined))
    const [first, ...others] = maps.filter((map) => map !== undefined)
    return others.some(({ width, height }) => width !== first.width || height !== first.height)
  })
}

/** Maps of one kind are in one array, occlusion and blood too. */
const KINDS = [['normal'], ['baseColor'], ['roughness'], ['occlusion', 'blood']] as const

/** All maps but heights, which only relief needs. */
async function readLayer(maps: WrinkleMapsLayer, source: MapSource): Promise<Layer<ArraySlice>> {
  const { name, kind, normalTexture, baseColorTexture, occlusionTexture, bloodTexture } = maps
  const layer = { name, kind, normalScale: normalTexture.scale } as Layer<ArraySlice>
  const gray = async (value: 'roughness' | 'occlusion' | 'blood') => {
    const texture = maps[`${value}Texture`]
    if (texture) layer[value] = await source.gray(texture, CHANNEL[value], 'maps')
  }
  const colours = async () => {
    if (baseColorTexture) layer.baseColor = await source.colours(baseColorTexture, 'colours')
  }
  const normals = async () => {
    layer.normal = await source.colours(normalTexture, 'maps')
  }
  await Promise.all([normals(), colours(), gray('roughness'), gray('occlusion'), gray('blood')])
  if (occlusionTexture) layer.occlusionStrength = occlusionTexture.strength
  if (bloodTexture) layer.bloodAmplitude = bloodTexture.amplitude
  return layer
}

/** The heights of layers, if any. As precise as areas are: a surface shows steps sooner than a colour does. */
async function readHeights(layers: readonly WrinkleMapsLayer[], source: MapSource) {
  try {
    return await Promise.all(
      layers.map(({ heightTexture }) => heightTexture && source.gray(heightTexture, CHANNEL.height, 'areas')),
    )
  } catch (error) {
    throw fileError(error, WRINKLE_MAPS, UNREADABLE)
  }
}

/** Reads the images and arrays of a file, each once. */
class MapSource {
  readonly #file: WrinkledFile
  readonly #decoded: DecodedBytes
  /** By their textures. */
  readonly images = new Map<number, Promise<RgbaImage>>()
  readonly arrays = new Map<number, Promise<FileArray>>()
  /** Images that do not tell their size before are decoded one after the other. */
  #decoding: Promise<unknown> = Promise.resolve()

  /** @param decoded counts what the images of the whole file take. */
  constructor(file: WrinkledFile, decoded: DecodedBytes) {
    this.#file = file
    this.#decoded = decoded
  }

  get hasSlices(): boolean {
    return this.arrays.size > 0
  }

  async colours(info: TextureReference, use: ArrayUse): Promise<RgbaImage | ArraySlice> {
    return this.#isSlice(info) ? this.#slice(info, 0, use) : this.#image(info.index)
  }

  async gray(info: TextureReference, channel: number, use: ArrayUse): Promise<GrayImage | ArraySlice> {
    if (this.#isSlice(info)) return this.#slice(info, channel, use)
    return channelOf(await this.#image(info.index), channel)
  }

  /** Compressed images are read as arrays of one slice. */
  #isSlice({ index, slice }: TextureReference): boolean {
    return slice !== undefined || isCompressed(this.#file, index)
  }

  #image(index: number): Promise<RgbaImage> {
    return once(this.images, index, async () => {
      const who = `${WRINKLE_MAPS} texture ${index}`
      const image = imageOf(this.#file.json.textures[index])
      const bytes = await this.#file.readBytes(image, who)
      if (!bytes) throw fileError('a texture without an image', who, UNREADABLE)
      const size = pngHeader(bytes)
      if (size) {
        this.#decoded.add(index, size, WRINKLE_MAPS)
        return decodeBytes(bytes, who)
      }
      const decoding = this.#decoding.then(() => this.#decode(index, bytes, who))
      this.#decoding = decoding.catch(() => {})
      return decoding
    })
  }

  async #decode(index: number, bytes: Uint8Array<ArrayBuffer>, who: string): Promise<RgbaImage> {
    this.#decoded.check(WRINKLE_MAPS)
    const image = await decodeBytes(bytes, who)
    this.#decoded.add(index, image, WRINKLE_MAPS)
    return image
  }

  async #slice({ index, slice = 0 }: TextureReference, channel: number, use: ArrayUse): Promise<ArraySlice> {
    const check = (shape: TextureShape) => this.#decoded.add(index, shape, WRINKLE_MAPS)
    const { array } = await once(this.arrays, index, () => this.#file.loadArray(index, use, check))
    return { array, slice, channel }
  }
}

/** Whether a texture is read as KTX 2: it has no other image, or the loader can read KTX 2 and prefers it. */
function isCompressed({ json, prefersArrays }: WrinkledFile, index: number): boolean {
  const { source, extensions } = json.textures[index]
  if (!extensions?.KHR_texture_basisu) return false
  return source === undefined || prefersArrays
}

/** Index of the image that is not KTX 2. */
function imageOf({ source, extensions }: FileTexture): number | undefined {
  return extensions?.EXT_texture_webp?.source ?? extensions?.EXT_texture_avif?.source ?? source
}

interface FileTexture {
  source?: number
  extensions?: Record<string, { source?: number } | undefined>
}

function once<K, T>(known: Map<K, Promise<T>>, key: K, make: () => Promise<T>): Promise<T> {
  const found = known.get(key) ?? make()
  known.set(key, found)
  return found
}
