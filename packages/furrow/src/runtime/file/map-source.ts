import { channelOf } from '../../core/channels.ts'
import { FurrowError } from '../../core/error.ts'
import { WRINKLE_MAPS } from '../../core/maps/declared.ts'
import type { DecodedBytes } from '../../core/maps/decoded-bytes.ts'
import { pngHeader } from '../../core/maps/png.ts'
import { mapProblems, type TextureShape, texturesOfFace } from '../../core/maps/rules.ts'
import type { MapsAndAreas, TextureReference } from '../../core/maps/wrinkle-maps.ts'
import type { ArraySlice, GrayImage, RgbaImage, WrinkleSet } from '../../core/types.ts'
import { decodeBytes } from './decode-image.ts'
import { fileError } from './file-error.ts'
import type { FileArray, FileArrays, GltfSource, MapUse } from './gltf-source.ts'

export const UNREADABLE = 'the wrinkles cannot be read'

/** Reads the wrinkle maps of a glTF file. Each image is decoded once. KTX 2 images are returned as slices of the engine's texture arrays. */
export class MapSource {
  readonly #file: GltfSource
  readonly #decoded: DecodedBytes
  /** Decoded images, by index of the texture. */
  readonly #images = new Map<number, Promise<RgbaImage>>()
  /** KTX 2 images and arrays, by index of the texture. */
  readonly #arrays = new Map<number, Promise<FileArray>>()
  #arrayReader: Promise<FileArrays> | undefined
  /**
   * Resolves when all queued images are decoded. Images that are not PNG are queued, because their size is unknown before decoding. Once the
   * decoded size of the file's images exceeds the limit, the rest of the queue fails without decoding.
   */
  #decoding: Promise<unknown> = Promise.resolve()

  /** @param decoded sums the decoded sizes of the file's images, and limits the sum. */
  constructor(file: GltfSource, decoded: DecodedBytes) {
    this.#file = file
    this.#decoded = decoded
  }

  async colours(texture: TextureReference, use: MapUse): Promise<RgbaImage | ArraySlice> {
    return this.#isArray(texture) ? this.#slice(texture, 0, use) : this.#image(texture.index)
  }

  async gray(texture: TextureReference, channel: number, use: MapUse): Promise<GrayImage | ArraySlice> {
    if (this.#isArray(texture)) return this.#slice(texture, channel, use)
    return channelOf(await this.#image(texture.index), channel)
  }

  /**
   * Checks all loaded images with `mapProblems`, and joins the texture arrays of each kind of map.
   *
   * @throws FurrowError if the maps break a rule.
   */
  async finish(set: WrinkleSet<ArraySlice>, maps: MapsAndAreas): Promise<WrinkleSet<ArraySlice>> {
    const shapes = new Map<number, TextureShape>()
    for (const [texture, image] of this.#images) shapes.set(texture, await image)
    for (const [texture, array] of this.#arrays) shapes.set(texture, (await array).header)
    const faceTextures = texturesOfFace(this.#file.json)
    const [problem] = mapProblems(maps, (texture) => shapes.get(texture)!, faceTextures, WRINKLE_MAPS)
    if (problem) throw new FurrowError(problem)
    return this.#arrayReader ? (await this.#arrayReader).join(set) : set
  }

  /** Whether a texture is read as a texture array. A single KTX 2 image is read as an array of one slice. */
  #isArray({ index, slice }: TextureReference): boolean {
    if (slice !== undefined) return true
    const { source, extensions }: FileTexture = this.#file.json.textures[index]
    return Boolean(extensions?.KHR_texture_basisu) && (source === undefined || this.#file.prefersArrays)
  }

  async #slice({ index, slice = 0 }: TextureReference, channel: number, use: MapUse): Promise<ArraySlice> {
    this.#arrayReader ??= this.#file.fetchArrays()
    const reader = this.#arrayReader
    const { array } = await cached(this.#arrays, index, async () =>
      (await reader).load(index, use, (shape) => this.#decoded.add(index, shape, WRINKLE_MAPS)),
    )
    return { array, slice, channel }
  }

  #image(index: number): Promise<RgbaImage> {
    return cached(this.#images, index, async () => {
      const who = `${WRINKLE_MAPS} texture ${index}`
      const bytes = await this.#file.readBytes(imageOf(this.#file.json.textures[index]), who)
      if (!bytes) throw fileError('texture without an image', who, UNREADABLE)
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
}

/** Returns the index of a texture's WebP, AVIF, PNG or JPEG image. Ignores KTX 2 images. */
function imageOf({ source, extensions }: FileTexture): number | undefined {
  return extensions?.EXT_texture_webp?.source ?? extensions?.EXT_texture_avif?.source ?? source
}

interface FileTexture {
  source?: number
  extensions?: Record<string, { source?: number } | undefined>
}

/** Returns the cached value of a key. If there is none, creates and caches it. */
export function cached<K, T>(known: Map<K, Promise<T>>, key: K, make: () => Promise<T>): Promise<T> {
  const found = known.get(key) ?? make()
  known.set(key, found)
  return found
}
