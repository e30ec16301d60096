import type { CheckedAccessor, CheckedJson } from '../json/checked-json.ts'
import { compressedViews } from '../json/gltf-json.ts'
import { elementBytes } from './accessor-bytes.ts'

/** Bytes of geometry that any file may decode to, and how many times its size a larger one may. */
const DECODED_BYTES = 2 ** 27
const DECODED_PER_BYTE = 32
/** The same for triangles: those of many blendshapes take less than a byte each only in files of few. */
const TRIANGLES = 250_000
const TRIANGLES_PER_BYTE = 1

/**
 * Checks how much a file decodes to, in proportion to its size. Few bytes can stand for many: elements without a view
 * are zeros, several accessors can have one view and several primitives one accessor, and compressed views may hold
 * anything.
 *
 * @returns what is wrong, or undefined.
 */
export function sizeProblem(
  { accessors = [], bufferViews = [], meshes = [] }: CheckedJson,
  fileBytes: number,
): string | undefined {
  const most = Math.max(DECODED_BYTES, DECODED_PER_BYTE * fileBytes)
  const mostTriangles = Math.max(TRIANGLES, TRIANGLES_PER_BYTE * fileBytes)
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
  if (largest > most) return `its meshes decode to ${megabytes(largest)}, more than ${megabytes(most)}`
  if (triangles > mostTriangles) {
    return `it has ${Math.floor(triangles)} triangles in ${fileBytes} bytes, more than ${mostTriangles}`
  }
  return undefined
}

/** 0 where there is no such accessor, or its type is unknown, which other checks report. */
function bytesOf(accessor: CheckedAccessor | undefined): number {
  return (accessor && accessor.count * elementBytes(accessor)) || 0
}

const megabytes = (bytes: number) => `${Math.ceil(bytes / 1e6)} MB`
