import type { CheckedJson } from '../json/checked-json.ts'
import type { GltfJson } from '../json/gltf-json.ts'
import { nodeProblem } from './nodes.ts'
import { rangeProblem } from './ranges.ts'
import { referenceProblem } from './references.ts'
import { sizeProblem } from './sizes.ts'

// Both take time in proportion to the size of a document, whose types `shapeProblem` has checked.

/**
 * What in a document would cost any reader too much time or memory: nodes in cycles or long chains, and counts out of
 * all proportion to the file.
 *
 * @param fileBytes size of the file with all that it refers to.
 * @returns what is wrong, or undefined.
 */
export function costProblem(json: GltfJson, fileBytes: number): string | undefined {
  return nodeProblem(json as CheckedJson) ?? sizeProblem(json as CheckedJson, fileBytes)
}

/**
 * What in a document points to nothing: references, and offsets, counts and strides beyond the bytes.
 *
 * @param binaryBytes of the binary chunk, the first buffer; no other buffer has bytes of its own.
 * @returns what is wrong, or undefined.
 */
export function decodingProblem(json: GltfJson, binaryBytes: number): string | undefined {
  const lengths = (json.buffers ?? []).map((_, i) => (i === 0 ? binaryBytes : 0))
  // Extensions that are not listed are not decoded (glTF 2.0, 3.12).
  const unlisted = json.extensionsRequired?.find((name) => !json.extensionsUsed?.includes(name))
  if (unlisted !== undefined) return `its extensionsUsed do not list ${unlisted}, which it requires`
  return referenceProblem(json as CheckedJson) ?? rangeProblem(json as CheckedJson, lengths)
}
