import { accessorProblem } from './check-accessors.ts'
import { nodeProblem } from './check-nodes.ts'
import { referenceProblem } from './check-references.ts'
import type { CheckedJson } from './checked-json.ts'
import type { GltfJson } from './gltf-json.ts'

/**
 * Checks everything in a document that tells a reader where to look, how much to allocate or how long to loop, in time
 * linear in its size. Its types have been checked, see `shapeProblem`.
 *
 * @param binaryBytes of the binary chunk, the first buffer; no other buffer has any bytes of its own.
 * @param fileBytes of the whole file.
 * @returns what is wrong, or undefined.
 */
export function documentProblem(json: GltfJson, binaryBytes: number, fileBytes: number): string | undefined {
  const checked = json as CheckedJson
  const lengths = (json.buffers ?? []).map((_, i) => (i === 0 ? binaryBytes : 0))
  return referenceProblem(checked) ?? nodeProblem(checked) ?? accessorProblem(checked, lengths, fileBytes)
}
