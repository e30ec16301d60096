import { WRINKLE_MAPS } from '../../core/maps/declared.ts'
import type { DecodedBytes } from '../../core/maps/decoded-bytes.ts'
import type { TextureShape } from '../../core/maps/rules.ts'
import type { TextureReference } from '../../core/maps/wrinkle-maps.ts'
import type { ArraySlice, GrayImage, RgbaImage, WrinkleSet } from '../../core/types.ts'
import type { WrinkleMaps } from '../../drivers/parse.ts'
import type { MapSource } from './map-source.ts'
import type { FileArray, FileArrays, MapUse, WrinkledFile } from './wrinkled-file.ts'

/** Reads the KTX 2 images and arrays of a file, each once, and leaves other images to `MapSource`. */
export class ArraySource {
  readonly #images: MapSource
  readonly #file: WrinkledFile
  readonly #decoded: DecodedBytes
  /** By their textures. */
  readonly #loading = new Map<number, Promise<FileArray>>()
  #arrays: Promise<FileArrays> | undefined

  /** @param decoded counts what the images of the whole file take. */
  constructor(images: MapSource, file: WrinkledFile, decoded: DecodedBytes) {
    this.#images = images
    this.#file = file
    this.#decoded = decoded
  }

  async colours(info: TextureReference, use: MapUse): Promise<RgbaImage | ArraySlice> {
    return this.#isSlice(info) ? this.#slice(info, 0, use) : this.#images.colours(info)
  }

  async gray(info: TextureReference, channel: number, use: MapUse): Promise<GrayImage | ArraySlice> {
    return this.#isSlice(info) ? this.#slice(info, channel, use) : this.#images.gray(info, channel)
  }

  async finish(set: WrinkleSet<ArraySlice>, maps: WrinkleMaps): Promise<WrinkleSet<ArraySlice>> {
    if (!this.#arrays) return this.#images.finish(set, maps)
    const shapes = new Map<number, TextureShape>()
    for (const [texture, array] of this.#loading) shapes.set(texture, (await array).header)
    await this.#images.check(maps, shapes)
    return (await this.#arrays).join(set)
  }

  /** Compressed images are read as arrays of one slice. */
  #isSlice({ index, slice }: TextureReference): boolean {
    if (slice !== undefined) return true
    const { source, extensions } = this.#file.json.textures[index]
    return Boolean(extensions?.KHR_texture_basisu) && (source === undefined || this.#file.prefersArrays)
  }

  async #slice({ index, slice = 0 }: TextureReference, channel: number, use: MapUse): Promise<ArraySlice> {
    this.#arrays ??= this.#file.fetchArrays()
    const loading = this.#loading.get(index) ?? this.#load(index, use, this.#arrays)
    this.#loading.set(index, loading)
    const { array } = await loading
    return { array, slice, channel }
  }

  async #load(index: number, use: MapUse, arrays: Promise<FileArrays>): Promise<FileArray> {
    return (await arrays).load(index, use, (shape) => this.#decoded.add(index, shape, WRINKLE_MAPS))
  }
}
