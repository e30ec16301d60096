import type { Reference } from '../base/references.ts'
import type { GltfJson } from '../json/gltf-json.ts'

/** A glTF file in two parts, as in its binary form. Commands edit the parts in place, so that whatever else it holds is kept. */
export interface Glb {
  json: GltfJson
  /** The binary chunk; empty where there is none. */
  bin: Uint8Array
  /** Size of all files that it was read from. */
  fileBytes: number
  /** The file as it was read. */
  bytes: Uint8Array
  /** Files that the source referred to, by URI; the binary chunk has their bytes. */
  references: ReadonlyMap<string, Reference>
}
