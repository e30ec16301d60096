/** Store of inputs and outputs: the file system, S3, or the web (inputs only). An address is a path or a URL. */
export interface FileStore {
  /**
   * Returns an identity of the content at an address. Equal identities mean equal content.
   *
   * @param reads `folder`: includes all files in it.
   */
  identify(address: string, reads: 'file' | 'folder'): Promise<string>
  /**
   * Makes the content at an address available as a file.
   *
   * @param scratch empty folder for downloads; the caller removes it.
   * @returns path of the file: in `scratch`, or the original path of a local file.
   * @throws FurrowError if the content cannot be read or no longer has the identity.
   */
  fetch(address: string, identity: string, reads: 'file' | 'folder', scratch: string): Promise<string>
  /** Reads the current bytes at an address. */
  read(address: string): Promise<Uint8Array>
  /** Writes a file atomically. */
  put(address: string, bytes: Uint8Array): Promise<void>
  /** Returns the size at an address in bytes, or undefined if it does not exist. */
  sizeOf(address: string): Promise<number | undefined>
}

/** Object in a listing. */
export interface ListedObject {
  address: string
  /** Content identity, if the listing has it; see `FileStore.identify`. */
  identity?: string
}
