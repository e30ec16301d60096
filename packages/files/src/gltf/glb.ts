import type { Reference } from '../base/references.ts'
import type { GltfJson } from '../json/gltf-json.ts'

/** Parsed glTF file. Commands edit its JSON and binary chunk in place, so that they keep all other content. */
export interface Glb {
  json: GltfJson
  /** Binary chunk. May be empty. */
  bin: Uint8Array
  /** Total size of the file and its referenced files. */
  fileBytes: number
  /** Original bytes of the file, without referenced files. */
  bytes: Uint8Array
  /** Referenced files by URI. The binary chunk contains copies of their bytes. */
  references: ReadonlyMap<string, Reference>
}
