/** Where inputs and outputs are: the file system, S3, or inputs on the web. An address is a path or a URL. */
export interface Place {
  /**
   * A text that stands for the content at an address: two addresses with the same have the same content.
   *
   * @param reads `folder`: all files in it.
   */
  identify(address: string, reads: 'file' | 'folder'): Promise<string>
  /**
   * Makes the content at an address a file.
   *
   * @param scratch an empty folder for it, which the caller removes.
   * @returns its path; elsewhere than in `scratch` where it is a file already.
   * @throws FurrowError also where it no longer has the identity.
   */
  fetch(address: string, identity: string, reads: 'file' | 'folder', scratch: string): Promise<string>
  /** The bytes at an address, as they are now. */
  read(address: string): Promise<Uint8Array>
  /** Puts a file to an address, whole or not at all. */
  put(address: string, bytes: Uint8Array): Promise<void>
  /** Bytes of what is at an address; undefined where nothing is. */
  sizeOf(address: string): Promise<number | undefined>
}

/** An object that a place lists. */
export interface Listed {
  address: string
  /** Where the list tells it; see `Place.identify`. */
  identity?: string
}
