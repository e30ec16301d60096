import type { TextureShape } from '../../core/maps/rules.ts'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'

/** The parts of a glTF file that reading its wrinkles needs; each engine supplies them. */
export interface GltfSource {
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
  /** Fetches what reads KTX 2: most files have none. */
  fetchArrays(): Promise<FileArrays>
}

/** Reads the KTX 2 images and arrays of a file. */
export interface FileArrays {
  /**
   * Loads one.
   *
   * @param index of its texture.
   * @param check throws where it may not be decoded.
   * @throws FurrowError when it cannot be read.
   */
  load(index: number, use: MapUse, check: (shape: TextureShape) => void): Promise<FileArray>
  /** Joins the arrays of each kind of map into one. */
  join(set: WrinkleSet<ArraySlice>): WrinkleSet<ArraySlice>
}

/** What an image is used for, which decides the format of arrays on the GPU. */
export type MapUse = 'areas' | 'maps' | 'colours'

/** A KTX 2 image or array of a file: a texture of the engine, and what its header says. */
export interface FileArray {
  array: object
  header: TextureShape
}
