import type { Reference } from '../base/references.ts'
import type { GltfJson } from '../json/gltf-json.ts'

/** glTF file as JSON and binary chunk. Commands edit both in place, so that all other content is kept. */
export interface Glb {
  json: GltfJson
  /** Binary chunk; may be empty. */
  bin: Uint8Array
  /** Total size of all source files. */
  fileBytes: number
  /** Original file. */
  bytes: Uint8Array
  /** Referenced files by URI. Their bytes are also in the binary chunk. */
  references: ReadonlyMap<string, Reference>
}
