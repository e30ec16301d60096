import type { CheckedJson } from '../json/checked-json.ts'
import type { GltfJson } from '../json/gltf-json.ts'
import { nodeProblem } from './nodes.ts'
import { rangeProblem } from './ranges.ts'
import { referenceProblem } from './references.ts'
import { sizeProblem } from './sizes.ts'

// Both checks take linear time and expect that `shapeProblem` has checked the types.

/**
 * Finds parts of a document that would cost too much time or memory: nodes in cycles or long chains, and counts out of
 * proportion to the file size.
 *
 * @param fileBytes size of the file with all referenced files.
 * @returns the problem, or undefined.
 */
export function costProblem(json: GltfJson, fileBytes: number): string | undefined {
  return nodeProblem(json as CheckedJson) ?? sizeProblem(json as CheckedJson, fileBytes)
}

/**
 * Finds invalid references, and offsets, counts and strides beyond the data.
 *
 * @param binaryBytes size of the binary chunk, the first buffer. Other buffers are empty.
 * @returns the problem, or undefined.
 */
export function decodingProblem(json: GltfJson, binaryBytes: number): string | undefined {
  const lengths = (json.buffers ?? []).map((_, i) => (i === 0 ? binaryBytes : 0))
  // Extensions that are not listed are not decoded (glTF 2.0, 3.12).
  const unlisted = json.extensionsRequired?.find((name) => !json.extensionsUsed?.includes(name))
  if (unlisted !== undefined) return `the required extension ${unlisted} is missing in extensionsUsed`
  return referenceProblem(json as CheckedJson) ?? rangeProblem(json as CheckedJson, lengths)
}
