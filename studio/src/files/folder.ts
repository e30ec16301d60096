import { dataOf, missing, normalised, parseJson, pathOf, WRINKLES_FILE } from 'furrow-files'
import { bytesOf } from './dropped-files.ts'

const WHO = 'Studio'

/** Project folder, which `furrow pack` can read. Its files are read when they are needed. */
export class Folder {
  readonly name: string
  /** Paths of all files, relative to the folder, with `/`. */
  readonly paths: readonly string[]
  readonly #files: ReadonlyMap<string, Blob>

  /** @param name folder name for errors. */
  constructor(files: readonly { path: string; file: Blob }[], name: string) {
    this.name = name
    this.#files = new Map(files.map(({ path, file }) => [path, file]))
    this.paths = [...this.#files.keys()]
  }

  /** Reads a JSON file, or returns undefined if it is missing. Throws FurrowError if the JSON is invalid or too deeply nested. */
  async json(address: string): Promise<unknown> {
    const file = this.#at(address)
    return file && parseJson(await bytesOf(file, address), address, WHO)
  }

  /** Returns the file to which an address in `wrinkles.json` refers. Throws FurrowError if the file is missing. */
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
