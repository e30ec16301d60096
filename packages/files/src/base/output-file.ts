export interface OutputFile {
  path: string
  bytes: Uint8Array
}
