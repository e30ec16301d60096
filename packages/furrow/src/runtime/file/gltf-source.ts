import type { TextureShape } from '../../core/maps/rules.ts'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'

/** Access to a glTF file, supplied by each engine. */
export interface GltfSource {
  // biome-ignore lint/suspicious/noExplicitAny: JSON of any shape
  readonly json: any
  /**
   * Reads the bytes of an image file, or returns undefined if the glTF file has no such image.
   *
   * @param image index of the image; may be any JSON value.
   * @param who name of the texture in errors.
   * @throws FurrowError if the image cannot be fetched.
   */
  readBytes(image: unknown, who: string): Promise<Uint8Array<ArrayBuffer> | undefined>
  /** Whether to load the KTX 2 image of a texture that also has an image in another format. */
  readonly prefersArrays: boolean
  /** Loads the code that reads KTX 2. It is a separate chunk, because most files have no KTX 2 images. */
  fetchArrays(): Promise<FileArrays>
}

/** Reads the KTX 2 images and arrays of a file. */
export interface FileArrays {
  /**
   * Loads a KTX 2 image or array.
   *
   * @param index index of the texture.
   * @param check is called with the size before decoding, and throws if the image is too large.
   * @throws FurrowError if the image cannot be read.
   */
  load(index: number, use: MapUse, check: (shape: TextureShape) => void): Promise<FileArray>
  /** Joins all texture arrays of the same kind of map (such as normals) into one array. */
  join(set: WrinkleSet<ArraySlice>): WrinkleSet<ArraySlice>
}

/**
 * Use of a KTX 2 image, which determines its GPU format and colour space. `areas`: weights of areas or heights. `colours`: base colours, in
 * sRGB. `maps`: normals and all other maps of layers.
 */
export type MapUse = 'areas' | 'maps' | 'colours'

export interface FileArray {
  /** The engine's texture object. */
  array: object
  header: TextureShape
}
