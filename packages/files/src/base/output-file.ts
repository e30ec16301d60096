/** File to write, in memory. */
export interface OutputFile {
  path: string
  bytes: Uint8Array
}
