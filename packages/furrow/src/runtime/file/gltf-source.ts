import type { TextureShape } from '../../core/maps/rules.ts'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'

/** Access to a glTF file, supplied by each engine. */
export interface GltfSource {
  // biome-ignore lint/suspicious/noExplicitAny: JSON of any shape
  readonly json: any
  /**
   * Reads the bytes of an image; undefined if the image does not exist.
   *
   * @param image index of the image.
   * @param who name of the texture in errors.
   * @throws FurrowError if the image cannot be fetched.
   */
  readBytes(image: unknown, who: string): Promise<Uint8Array<ArrayBuffer> | undefined>
  /** Whether KTX 2 is preferred for textures that also have another image. */
  readonly prefersArrays: boolean
  /** Loads the KTX 2 reader, a lazy chunk because most files have no KTX 2. */
  fetchArrays(): Promise<FileArrays>
}

/** Reads the KTX 2 images and arrays of a file. */
export interface FileArrays {
  /**
   * Loads an image or array.
   *
   * @param index index of the texture.
   * @param check throws if the image must not be decoded.
   * @throws FurrowError if the image cannot be read.
   */
  load(index: number, use: MapUse, check: (shape: TextureShape) => void): Promise<FileArray>
  /** Joins the arrays of each kind of map into one array. */
  join(set: WrinkleSet<ArraySlice>): WrinkleSet<ArraySlice>
}

/** Use of an image, which decides the GPU format of arrays. */
export type MapUse = 'areas' | 'maps' | 'colours'

/** A KTX 2 image or array: the engine's texture, and the shape in the header. */
export interface FileArray {
  array: object
  header: TextureShape
}
