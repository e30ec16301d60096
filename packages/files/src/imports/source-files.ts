/** Files of an export from another program. */
export interface SourceFiles {
  /** Name of the folder or document, for errors. */
  name: string
  /** Path of the document that the user named. Default: the document is found. */
  document?: string
  /** Paths relative to the folder, with `/` as separator, sorted. */
  paths: readonly string[]
  /**
   * Reads a file.
   *
   * @param path relative to the folder.
   * @throws FurrowError if the file is missing, too large, or outside the folder.
   */
  read(path: string): Promise<Uint8Array>
}

/** Returns the name of a file without folders and extension, in lower case. */
export function stemOf(path: string): string {
  return path
    .split('/')
    .at(-1)!
    .replace(/\.[^.]*$/, '')
    .toLowerCase()
}

const IMAGE = /\.(png|jpe?g|webp|tiff?|tga)$/i

/** Tells whether a path has the extension of an image that `readSourceImage` decodes. */
export function isImagePath(path: string): boolean {
  return IMAGE.test(path)
}
