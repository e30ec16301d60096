import { type ColorSpace, type Material, type Mesh, NoColorSpace, type Object3D, SRGBColorSpace } from 'three'
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js'
import { CHANNEL, channelOf } from '../../core/channels.ts'
import { FurrowError } from '../../core/error.ts'
import { checkDeclared, WRINKLE_MAPS } from '../../core/maps/declared.ts'
import { DecodedBytes } from '../../core/maps/decoded-bytes.ts'
import type { TextureShape } from '../../core/maps/rules.ts'
import type { MapsAndAreas, TextureReference, WrinkleMapsLayer } from '../../core/maps/wrinkle-maps.ts'
import type { Area, ArraySlice, GrayImage, Layer, RgbaImage, WrinkleSet } from '../../core/types.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import { readUsualMaps } from '../../drivers/usual-maps.ts'
import { surfaceOf } from '../material/surface.ts'
import { decodeBytes } from './decode-image.ts'
import { fileError } from './file-error.ts'
import { readImageBytes } from './image-bytes.ts'
import type { Ktx2Texture } from './ktx2.ts'

/** A face of a file: meshes that have one material with the extension. */
export interface FileFace {
  /** The primitives of a glTF mesh. The first one drives. */
  meshes: [Mesh, ...Mesh[]]
  /** Index of the material in the file. */
  material: number
}

/** The wrinkles of a material in a file. */
export interface FileWrinkles {
  /** The same object for all faces that have the same material in the file. */
  set: WrinkleSet<ArraySlice>
  /** For `addDrivers`. */
  drivers: WrinkleDriver[]
}

/** The wrinkles of one face in a file. */
export interface LoadedWrinkles extends FileWrinkles {
  /** The meshes of the face, which have one material: the primitives of a glTF mesh. The first one drives. */
  meshes: [Mesh, ...Mesh[]]
}

type Parser = GLTF['parser']

const UNREADABLE = 'the wrinkles cannot be read'

/**
 * Reads FURROW_wrinkle_maps from a file that three.js's `GLTFLoader` has loaded, as plain data for any renderer. `WrinkleLoaderPlugin`
 * calls it by itself.
 *
 * @param gltf what the loader returned.
 * @param parser the loader's, `gltf.parser` by default.
 * @returns one entry for each face that has the extension.
 * @throws FurrowError when the extension is malformed or an image cannot be read.
 */
export async function readWrinkleMaps(gltf: GLTF, parser: Parser = gltf.parser): Promise<LoadedWrinkles[]> {
  const wrinklesOf = materialReader(parser, { withHeights: true })
  const found: LoadedWrinkles[] = []
  for (const { meshes, material } of wrinkledFaces(gltf, parser)) {
    found.push({ meshes, ...(await wrinklesOf(material)) })
  }
  return found
}

/** The faces whose materials have the extension, malformed or not. */
export function wrinkledFaces(gltf: GLTF, parser: Parser): FileFace[] {
  return facesOf(gltf, parser).flatMap((meshes) => {
    // The loader clones materials; the clones are of the same material in the file.
    const material = parser.associations.get(surfaceOf(meshes[0]))?.materials
    if (material === undefined || extensionOf(material, parser) === undefined) return []
    return { meshes, material }
  })
}

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
export function materialReader(
  parser: Parser,
  options: ReadOptions = {},
): (material: number) => Promise<FileWrinkles> {
  const known = new Map<number, Promise<FileWrinkles>>()
  const decoded = new DecodedBytes()
  const read = async (material: number): Promise<FileWrinkles> => {
    const { textures } = parser.json
    const count = Array.isArray(textures) ? textures.length : 0
    try {
      const json = extensionOf(material, parser)
      const maps = readUsualMaps(json, count) ?? (await parseMaps(json, count, options.onFault))
      return { set: await readSet(maps, parser, decoded, options), drivers: maps.drivers }
    } catch (error) {
      throw fileError(error, WRINKLE_MAPS, UNREADABLE)
    }
  }
  return (material) => once(known, material, () => read(material))
}

/** Begins to fetch what reads a file that is out of the usual, so that it arrives while the rest is loaded. */
export function prefetchParser({ json }: Parser): void {
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

/** Groups meshes by face: the primitives of a glTF mesh that have one material are one face. */
export function facesOf(gltf: GLTF, parser: Parser): [Mesh, ...Mesh[]][] {
  const faces = new Map<Object3D, Map<Material, [Mesh, ...Mesh[]]>>()
  for (const scene of gltf.scenes) {
    scene.traverse((object) => {
      const mesh = object as Mesh
      if (!mesh.isMesh) return
      const whole = isPart(mesh, parser) ? mesh.parent! : mesh
      const parts = faces.get(whole) ?? new Map<Material, [Mesh, ...Mesh[]]>()
      faces.set(whole, parts)
      const material = surfaceOf(mesh)
      const meshes = parts.get(material)
      if (!meshes) parts.set(material, [mesh])
      else if (!meshes.includes(mesh)) meshes.push(mesh)
    })
  }
  return [...faces.values()].flatMap((parts) => [...parts.values()])
}

/** Whether a mesh is one of several primitives of a glTF mesh, which the loader turns into a group. */
function isPart(mesh: Mesh, parser: Parser): boolean {
  const index = parser.associations.get(mesh)?.meshes
  return index !== undefined && parser.json.meshes[index].primitives.length > 1
}

function extensionOf(material: number, parser: Parser): unknown {
  return parser.json.materials[material].extensions?.[WRINKLE_MAPS]
}

async function readSet(
  maps: MapsAndAreas,
  parser: Parser,
  decoded: DecodedBytes,
  { withHeights }: ReadOptions,
): Promise<WrinkleSet<ArraySlice>> {
  checkDeclared(parser.json, WRINKLE_MAPS)
  const source = new MapSource(parser, decoded)
  const layers = await Promise.all(maps.layers.map((layer) => readLayer(layer, source)))
  const areas = maps.areas.map(
    async ({ name, layer, texture, channel, combine, activation }): Promise<Area<ArraySlice>> => ({
      name,
      layer: layers[layer].name,
      combine,
      activation,
      weights: await source.gray(texture, channel, 'areas'),
    }),
  )
  const set = { layers, areas: await Promise.all(areas) }
  if (source.hasSlices || differInSize(layers)) await checkMaps(maps, source, parser)
  let heights: ReturnType<typeof readHeights> | undefined
  for (const [i, { heightTexture }] of maps.layers.entries()) {
    if (!heightTexture) continue
    // A source of its own: nothing else that was decoded stays in memory until heights are wanted.
    const readHeight = async () => {
      heights ??= readHeights(maps.layers, new MapSource(parser, decoded))
      return (await heights)[i]!
    }
    Object.assign(layers[i], { heightAmplitude: heightTexture.amplitude })
    Object.assign(layers[i], withHeights ? { height: await readHeight() } : { readHeight })
  }
  // Most files have no KTX 2 images: what only these need is fetched when one appears.
  return source.hasSlices ? (await import('./join-arrays.ts')).joinArrays(set) : set
}

/** Whether the images of some kind do; nothing else can be wrong with images that were decoded. */
function differInSize(layers: readonly Layer<ArraySlice>[]): boolean {
  const sizesOf = (...kinds: ('normal' | 'baseColor' | 'roughness' | 'occlusion' | 'blood')[]) =>
    new Set(
      layers.flatMap((layer) =>
        kinds.flatMap((kind) => (layer[kind] ? sizeOf(layer[kind] as RgbaImage) : [])),
      ),
    )
  const sizes = [sizesOf('normal'), sizesOf('baseColor'), sizesOf('roughness'), sizesOf('occlusion', 'blood')]
  return sizes.some(({ size }) => size > 1)
}

const sizeOf = ({ width, height }: RgbaImage) => `${width} x ${height}`

/** @throws FurrowError when the maps break a rule. */
async function checkMaps(maps: MapsAndAreas, source: MapSource, { json }: Parser): Promise<void> {
  const { mapProblems, texturesOfFace } = await import('../../core/maps/rules.ts')
  const [problem] = mapProblems(maps, await source.shapes(), texturesOfFace(json), WRINKLE_MAPS)
  if (problem) throw new FurrowError(problem)
}

/** All maps but heights, which only relief needs. */
async function readLayer(layer: WrinkleMapsLayer, source: MapSource): Promise<Layer<ArraySlice>> {
  const { name, kind, normalTexture, baseColorTexture, roughnessTexture, occlusionTexture, bloodTexture } =
    layer
  const gray = (info: TextureReference, channel: number) => source.gray(info, channel, 'maps')
  return {
    name,
    kind,
    normal: await source.colours(normalTexture),
    normalScale: normalTexture.scale,
    ...(baseColorTexture && { baseColor: await source.colours(baseColorTexture, SRGBColorSpace) }),
    ...(roughnessTexture && { roughness: await gray(roughnessTexture, CHANNEL.roughness) }),
    ...(occlusionTexture && {
      occlusion: await gray(occlusionTexture, CHANNEL.occlusion),
      occlusionStrength: occlusionTexture.strength,
    }),
    ...(bloodTexture && {
      blood: await gray(bloodTexture, CHANNEL.blood),
      bloodAmplitude: bloodTexture.amplitude,
    }),
  }
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

/** What an array is used for, which decides its format on the GPU. */
type ArrayUse = 'areas' | 'maps'

/** Reads the images and arrays of a file, each once. */
class MapSource {
  readonly #parser: Parser
  readonly #decoded: DecodedBytes
  readonly #images = new Map<number, Promise<RgbaImage>>()
  readonly #arrays = new Map<number, Promise<Ktx2Texture>>()
  /** Images are decoded one after the other: most tell their size only then. */
  #decoding: Promise<unknown> = Promise.resolve()

  /** @param decoded counts what the images of the whole file take. */
  constructor(parser: Parser, decoded: DecodedBytes) {
    this.#parser = parser
    this.#decoded = decoded
  }

  get hasSlices(): boolean {
    return this.#arrays.size > 0
  }

  /** What the images and arrays are that were read. */
  async shapes(): Promise<(texture: number) => TextureShape> {
    const images = [...this.#images].map(async ([index, image]) => [index, await image] as const)
    const arrays = [...this.#arrays].map(async ([index, array]) => [index, (await array).header] as const)
    const shapes = new Map<number, TextureShape>(await Promise.all([...images, ...arrays]))
    // All textures that are drawn have been read.
    return (texture) => shapes.get(texture)!
  }

  async colours(info: TextureReference, space?: ColorSpace): Promise<RgbaImage | ArraySlice> {
    return this.#isSlice(info) ? this.#slice(info, 0, 'maps', space) : this.#image(info.index)
  }

  async gray(info: TextureReference, channel: number, use: ArrayUse): Promise<GrayImage | ArraySlice> {
    if (this.#isSlice(info)) return this.#slice(info, channel, use)
    return channelOf(await this.#image(info.index), channel)
  }

  /** Compressed images are read as arrays of one slice. */
  #isSlice({ index, slice }: TextureReference): boolean {
    return slice !== undefined || isCompressed(this.#parser, index)
  }

  #image(index: number): Promise<RgbaImage> {
    return once(this.#images, index, async () => {
      const who = `${WRINKLE_MAPS} texture ${index}`
      const image = imageOf(this.#parser.json.textures[index])
      const bytes = await readImageBytes(this.#parser, image, who)
      if (!bytes) throw fileError('a texture without an image', who, UNREADABLE)
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

  async #slice(
    { index, slice = 0 }: TextureReference,
    channel: number,
    use: ArrayUse,
    space: ColorSpace = NoColorSpace,
  ): Promise<ArraySlice> {
    const { array } = await once(this.#arrays, index, async () => {
      const { loadAreaArray, loadMapArray } = await import('./ktx2.ts')
      return (use === 'areas' ? loadAreaArray : loadMapArray)(this.#parser, index, (shape) =>
        this.#decoded.add(index, shape, WRINKLE_MAPS),
      )
    })
    // In glTF the use of a texture decides, not the colour space in its file.
    array.colorSpace = space
    return { array, slice, channel }
  }
}

/** Whether a texture is read as KTX 2: it has no other image, or the loader can read KTX 2 and prefers it. */
function isCompressed(parser: Parser, index: number): boolean {
  const { source, extensions } = parser.json.textures[index]
  if (!extensions?.KHR_texture_basisu) return false
  return source === undefined || Boolean((parser.options as { ktx2Loader?: unknown }).ktx2Loader)
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
