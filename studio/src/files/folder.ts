import { dataOf, missing, normalised, parseJson, pathOf, WRINKLES_FILE } from 'furrow-files'
import { bytesOf } from './dropped-files.ts'

const WHO = 'Studio'

/** A folder as `furrow pack` reads it. Its files are read as they are asked for. */
export class Folder {
  readonly name: string
  /** Of all files below it, relative to it, with `/`. */
  readonly paths: readonly string[]
  readonly #files: ReadonlyMap<string, Blob>

  /** @param name for errors. */
  constructor(files: readonly { path: string; file: Blob }[], name: string) {
    this.name = name
    this.#files = new Map(files.map(({ path, file }) => [path, file]))
    this.paths = [...this.#files.keys()]
  }

  /** The JSON at an address; undefined where there is no file. Throws FurrowError when it is not JSON, or too deep. */
  async json(address: string): Promise<unknown> {
    const file = this.#at(address)
    return file && parseJson(await bytesOf(file, address), address, WHO)
  }

  /** The file at an address in `wrinkles.json`. Throws FurrowError where there is none. */
  file(address: string): Blob {
    const file = this.#at(address)
    if (file) return file
    throw missing(WRINKLES_FILE, address, WHO, new Error(`it is not in the folder ${this.name}`))
  }

  #at(address: string): Blob | undefined {
    const data = dataOf(address)
    if (data) return new Blob([data as Uint8Array<ArrayBuffer>])
    return this.#files.get(normalised(pathOf(WRINKLES_FILE, address, WHO)))
  }
}
