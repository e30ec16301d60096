import type { CheckedJson } from '../json/checked-json.ts'
import type { GltfJson } from '../json/gltf-json.ts'
import { nodeProblem } from './nodes.ts'
import { rangeProblem } from './ranges.ts'
import { referenceProblem } from './references.ts'
import { sizeProblem } from './sizes.ts'

// `costProblem` and `decodingProblem` take linear time. Call `shapeProblem` before them, because they rely on the types
// of all fields.

/**
 * Finds content that would take too much time or memory: node hierarchies with cycles or great depth, and counts that
 * are too large for the size of the file.
 *
 * @param fileBytes size of the file plus all referenced files.
 * @returns error text, or undefined.
 */
export function costProblem(json: GltfJson, fileBytes: number): string | undefined {
  return nodeProblem(json as CheckedJson) ?? sizeProblem(json as CheckedJson, fileBytes)
}

/**
 * Finds invalid indices, and offsets, counts and strides that exceed the data.
 *
 * @param binaryBytes size of the binary chunk, which is the first buffer. Other buffers count as empty, so references to
 *   their data are errors.
 * @returns error text, or undefined.
 */
export function decodingProblem(json: GltfJson, binaryBytes: number): string | undefined {
  const lengths = (json.buffers ?? []).map((_, i) => (i === 0 ? binaryBytes : 0))
  // Loaders do not decode extensions that `extensionsUsed` does not list (glTF 2.0, 3.12).
  const unlisted = json.extensionsRequired?.find((name) => !json.extensionsUsed?.includes(name))
  if (unlisted !== undefined) return `the required extension ${unlisted} is missing in extensionsUsed`
  return referenceProblem(json as CheckedJson) ?? rangeProblem(json as CheckedJson, lengths)
}
