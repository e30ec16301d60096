import type { CheckedAccessor, CheckedJson } from '../json/checked-json.ts'
import { type BufferView, compressedViews } from '../json/gltf-json.ts'
import { COMPONENT_BYTES, COMPONENTS, elementBytes } from './accessor-bytes.ts'

/** Component type that cannot be normalized (glTF 2.0, 3.6.2.2). */
const UNSIGNED_INT = 5125
const SPARSE_INDICES = [5121, 5123, 5125]

/**
 * Checks that every buffer view is within its buffer, and every accessor within its buffer view. Call
 * `referenceProblem` first, because this check relies on valid indices.
 *
 * @param lengths available bytes per buffer. Fallback buffers of compressed buffer views have 0 bytes.
 * @returns error text, or undefined.
 */
export function rangeProblem(json: CheckedJson, lengths: readonly number[]): string | undefined {
  return viewProblem(json, lengths) ?? accessorProblem(json)
}

function viewProblem({ bufferViews = [] }: CheckedJson, lengths: readonly number[]): string | undefined {
  for (const [i, view] of bufferViews.entries()) {
    const compressed = compressedViews(view)
    for (const { count, byteStride } of compressed) {
      if (count * byteStride === view.byteLength) continue
      return `bufferViews[${i}] has ${view.byteLength} bytes, but its compressed data has ${count} x ${byteStride}`
    }
    for (const { buffer, byteOffset = 0, byteLength } of compressed.length > 0 ? compressed : [view]) {
      const end = byteOffset + byteLength
      if (!(end <= lengths[buffer])) return `bufferViews[${i}] ends at ${end} of ${lengths[buffer]} bytes`
    }
  }
  return undefined
}

function accessorProblem({ accessors = [], bufferViews = [] }: CheckedJson): string | undefined {
  for (const [i, accessor] of accessors.entries()) {
    const where = `accessors[${i}]`
    const { count, componentType, normalized, type, bufferView, sparse } = accessor
    if (!COMPONENT_BYTES.has(componentType)) return `${where} has the unknown component type ${componentType}`
    if (!COMPONENTS.has(type)) return `${where} has the unknown type "${type.slice(0, 20)}"`
    if (normalized && componentType === UNSIGNED_INT) return `${where} has normalized 32-bit integers`
    const problem = bufferView !== undefined && spanProblem(where, accessor, count, bufferViews[bufferView])
    if (problem) return problem
    if (!sparse) continue
    if (!SPARSE_INDICES.includes(sparse.indices.componentType)) {
      return `${where} has sparse indices of the component type ${sparse.indices.componentType}`
    }
    for (const [part, form] of [
      ['indices', { ...sparse.indices, type: 'SCALAR' }],
      ['values', { ...sparse.values, componentType, type }],
    ] as const) {
      const view = bufferViews[form.bufferView]
      const problem = spanProblem(`${where}.sparse.${part}`, form, sparse.count, {
        ...view,
        byteStride: undefined,
      })
      if (problem) return problem
    }
  }
  return undefined
}

/** Checks that the elements of an accessor are aligned, do not overlap, and end within the buffer view. */
function spanProblem(
  where: string,
  { byteOffset = 0, ...form }: Pick<CheckedAccessor, 'byteOffset' | 'componentType' | 'type'>,
  count: number,
  view: BufferView,
): string | undefined {
  const component = COMPONENT_BYTES.get(form.componentType)!
  const element = elementBytes(form)
  const stride = view.byteStride ?? element
  if (stride < element) return `${where} has a stride of ${stride}, less than an element of ${element} bytes`
  if (byteOffset % component !== 0 || stride % component !== 0) {
    return `${where} is not aligned to ${component} bytes`
  }
  const end = count === 0 ? 0 : byteOffset + (count - 1) * stride + element
  return end > view.byteLength ? `${where} ends at ${end} of ${view.byteLength} bytes` : undefined
}
