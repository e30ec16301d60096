/** A file to write: its whole content, still in memory. */
export interface OutputFile {
  path: string
  bytes: Uint8Array
}
