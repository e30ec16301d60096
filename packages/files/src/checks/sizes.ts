import type { CheckedAccessor, CheckedJson } from '../json/checked-json.ts'
import { compressedViews } from '../json/gltf-json.ts'
import { elementBytes } from './accessor-bytes.ts'

/** Decoded geometry may take 128 MiB, or 32 bytes per byte of the file if that is more. */
const DECODED_BYTES = 2 ** 27
const DECODED_PER_BYTE = 32
/** A file may have 250,000 triangles, or one per byte of the file if that is more. */
const TRIANGLES = 250_000
const TRIANGLES_PER_BYTE = 1

/**
 * Compares the decoded size of a file's meshes with the size of the file. A small file can decode to large meshes:
 * accessors without a buffer view contain zeros, several accessors can share data, and data can be compressed.
 *
 * @returns error text, or undefined.
 */
export function sizeProblem(
  { accessors = [], bufferViews = [], meshes = [] }: CheckedJson,
  fileBytes: number,
): string | undefined {
  const maxBytes = Math.max(DECODED_BYTES, DECODED_PER_BYTE * fileBytes)
  const maxTriangles = Math.max(TRIANGLES, TRIANGLES_PER_BYTE * fileBytes)
  let [stored, unpacked, used, triangles] = [0, 0, 0, 0]
  for (const [i, accessor] of accessors.entries()) {
    const { count, sparse } = accessor
    if (sparse && sparse.count > count) return `accessors[${i}] replaces ${sparse.count} of ${count} elements`
    stored += bytesOf(accessor)
  }
  for (const view of bufferViews) unpacked += compressedViews(view).length > 0 ? view.byteLength : 0
  for (const { primitives } of meshes) {
    for (const { attributes = {}, targets = [], indices } of primitives) {
      for (const list of [attributes, ...targets]) {
        for (const index of Object.values(list)) used += bytesOf(accessors[index])
      }
      triangles += (accessors[indices ?? attributes.POSITION ?? -1]?.count ?? 0) / 3
    }
  }
  const largest = Math.max(stored, unpacked, used)
  if (largest > maxBytes)
    return `its meshes decode to ${megabytes(largest)}, more than ${megabytes(maxBytes)}`
  if (triangles > maxTriangles) {
    return `it has ${Math.floor(triangles)} triangles in ${fileBytes} bytes, more than ${maxTriangles}`
  }
  return undefined
}

/** Returns 0 if the accessor is missing or its type is unknown. Other checks report both. */
function bytesOf(accessor: CheckedAccessor | undefined): number {
  return (accessor && accessor.count * elementBytes(accessor)) || 0
}

const megabytes = (bytes: number) => `${Math.ceil(bytes / 1e6)} MB`
