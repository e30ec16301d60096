/** Storage of inputs and outputs: the file system, S3, or web servers. An address is a path or a URL. */
export interface FileStore {
  /**
   * Returns the content identity of an address. If two identities are equal, the contents are equal.
   *
   * @param reads whether the address is a file or a folder. The identity of a folder covers all files in it.
   */
  identify(address: string, reads: 'file' | 'folder'): Promise<string>
  /**
   * Makes the content of an address available as a local file.
   *
   * @param scratch empty folder for downloads. The caller removes it.
   * @returns path of a file in `scratch`, or the original path of a local file.
   * @throws FurrowError if the content cannot be read, or its identity has changed.
   */
  fetch(address: string, identity: string, reads: 'file' | 'folder', scratch: string): Promise<string>
  /** Reads the current content of an address. */
  read(address: string): Promise<Uint8Array>
  /** Writes a file atomically. */
  put(address: string, bytes: Uint8Array): Promise<void>
  /** Returns the size of the content in bytes, or undefined if the address does not exist. */
  sizeOf(address: string): Promise<number | undefined>
}

/** Object in an S3 listing. */
export interface ListedObject {
  address: string
  /** Content identity, if the listing has an ETag. See `FileStore.identify`. */
  identity?: string
}
