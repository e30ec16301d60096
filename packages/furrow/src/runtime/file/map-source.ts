import { channelOf } from '../../core/channels.ts'
import { WRINKLE_MAPS } from '../../core/maps/declared.ts'
import type { DecodedBytes } from '../../core/maps/decoded-bytes.ts'
import { pngHeader } from '../../core/maps/png.ts'
import type { TextureShape } from '../../core/maps/rules.ts'
import type { TextureReference } from '../../core/maps/wrinkle-maps.ts'
import type { ArraySlice, GrayImage, Layer, RgbaImage, WrinkleSet } from '../../core/types.ts'
import type { WrinkleMaps } from '../../drivers/parse.ts'
import { decodeBytes } from './decode-image.ts'
import { fileError } from './file-error.ts'
import type { WrinkledFile } from './wrinkled-file.ts'

export const UNREADABLE = 'the wrinkles cannot be read'

/** Reads the images of a file, each once. */
export class MapSource {
  readonly #file: WrinkledFile
  readonly #decoded: DecodedBytes
  /** By their textures. */
  readonly #images = new Map<number, Promise<RgbaImage>>()
  /** Images that do not tell their size before are decoded one after the other. */
  #decoding: Promise<unknown> = Promise.resolve()

  /** @param decoded counts what the images of the whole file take. */
  constructor(file: WrinkledFile, decoded: DecodedBytes) {
    this.#file = file
    this.#decoded = decoded
  }

  async colours({ index }: TextureReference): Promise<RgbaImage | ArraySlice> {
    return this.#image(index)
  }

  async gray({ index }: TextureReference, channel: number): Promise<GrayImage | ArraySlice> {
    return channelOf(await this.#image(index), channel)
  }

  /** The set of all that was read, when it has been checked. */
  async finish(set: WrinkleSet<ArraySlice>, maps: WrinkleMaps): Promise<WrinkleSet<ArraySlice>> {
    if (differInSize(set.layers)) await this.check(maps)
    return set
  }

  /**
   * Checks the maps of a file against each other, and against its own maps.
   *
   * @param shapes of all that was read elsewhere, by their textures.
   */
  async check(maps: WrinkleMaps, shapes = new Map<number, TextureShape>()): Promise<void> {
    for (const [texture, image] of this.#images) shapes.set(texture, await image)
    const { checkMaps } = await import('./check-maps.ts')
    checkMaps(maps, shapes, this.#file.json)
  }

  #image(index: number): Promise<RgbaImage> {
    return once(this.#images, index, async () => {
      const who = `${WRINKLE_MAPS} texture ${index}`
      const bytes = await this.#file.readBytes(imageOf(this.#file.json.textures[index]), who)
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

/** Index of the image that is not KTX 2. */
function imageOf({ source, extensions }: FileTexture): number | undefined {
  return extensions?.EXT_texture_webp?.source ?? extensions?.EXT_texture_avif?.source ?? source
}

interface FileTexture {
  source?: number
  extensions?: Record<string, { source?: number } | undefined>
}

export function once<K, T>(known: Map<K, Promise<T>>, key: K, make: () => Promise<T>): Promise<T> {
  const found = known.get(key) ?? make()
  known.set(key, found)
  return found
}
