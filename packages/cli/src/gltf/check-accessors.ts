import { type CheckedJson, compressedView } from './checked-json.ts'

/** Bytes of each component type, and components of each type of element (glTF 2.0, 3.6.2.2). */
const COMPONENT_BYTES = new Map([
  [5120, 1],
  [5121, 1],
  [5122, 2],
  [5123, 2],
  [5125, 4],
  [5126, 4],
])
const COMPONENTS = new Map([
  ['SCALAR', 1],
  ['VEC2', 2],
  ['VEC3', 3],
  ['VEC4', 4],
  ['MAT2', 4],
  ['MAT3', 9],
  ['MAT4', 16],
])
const SPARSE_INDICES = [5121, 5123, 5125]

/** Bytes of geometry that any file may decode to, and how many times its size a larger one may. */
const DECODED_BYTES = 2 ** 27
const DECODED_PER_BYTE = 32
/** The same for triangles: those of many blendshapes take less than a byte each only in files of few. */
const TRIANGLES = 250_000
const TRIANGLES_PER_BYTE = 1

/**
 * Checks the counts, offsets and strides of a file against its bytes: every number that tells a reader how much to
 * allocate or how long to loop. Types and references have been checked.
 *
 * @param lengths bytes of each buffer that are there; 0 for those of which only compressed views have bytes.
 * @param fileBytes size of the whole file.
 * @returns what is wrong, or undefined.
 */
export function accessorProblem(
  json: CheckedJson,
  lengths: readonly number[],
  fileBytes: number,
): string | undefined {
  return viewProblem(json, lengths) ?? rangeProblem(json) ?? sizeProblem(json, fileBytes)
}

type View = NonNullable<CheckedJson['bufferViews']>[number]
type Accessor = NonNullable<CheckedJson['accessors']>[number]

function viewProblem({ bufferViews = [] }: CheckedJson, lengths: readonly number[]): string | undefined {
  for (const [i, view] of bufferViews.entries()) {
    const packed = compressedView(view)
    const { buffer, byteOffset = 0, byteLength } = packed ?? view
    const end = byteOffset + byteLength
    if (!(end <= lengths[buffer])) return `bufferViews[${i}] ends at ${end} of ${lengths[buffer]} bytes`
    if (packed && packed.count * packed.byteStride !== view.byteLength) {
      return `bufferViews[${i}] has ${view.byteLength} bytes, its compressed form ${packed.count} x ${packed.byteStride}`
    }
  }
  return undefined
}

function rangeProblem({ accessors = [], bufferViews = [] }: CheckedJson): string | undefined {
  for (const [i, accessor] of accessors.entries()) {
    const where = `accessors[${i}]`
    const { count, componentType, type, bufferView, sparse } = accessor
    if (!COMPONENT_BYTES.has(componentType)) return `${where} has the component type ${componentType}`
    if (!COMPONENTS.has(type)) return `${where} has the type "${type.slice(0, 20)}"`
    const problem = bufferView !== undefined && spanProblem(where, accessor, count, bufferViews[bufferView])
    if (problem) return problem
    if (!sparse) continue
    if (sparse.count > count) return `${where} replaces ${sparse.count} of ${count} elements`
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

/** Whether elements in a view are aligned, do not overlap, and end within it. */
function spanProblem(
  where: string,
  { byteOffset = 0, ...form }: Pick<Accessor, 'byteOffset' | 'componentType' | 'type'>,
  count: number,
  view: View,
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

function elementBytes({ componentType, type }: Pick<Accessor, 'componentType' | 'type'>): number {
  return COMPONENT_BYTES.get(componentType)! * COMPONENTS.get(type)!
}

/**
 * Few bytes can stand for many: elements without a view are zeros, several accessors can have one view and several
 * primitives one accessor, and compressed views may hold anything.
 */
function sizeProblem({ accessors = [], bufferViews = [], meshes = [] }: CheckedJson, fileBytes: number) {
  const most = Math.max(DECODED_BYTES, DECODED_PER_BYTE * fileBytes)
  const bytesOf = (accessor: Accessor) => accessor.count * elementBytes(accessor)
  const stored = accessors.reduce((sum, accessor) => sum + bytesOf(accessor), 0)
  const unpacked = bufferViews.reduce((sum, view) => sum + (compressedView(view) ? view.byteLength : 0), 0)
  let [used, triangles] = [0, 0]
  for (const { primitives } of meshes) {
    for (const { attributes = {}, targets = [], indices } of primitives) {
      for (const list of [attributes, ...targets]) {
        for (const index of Object.values(list)) used += bytesOf(accessors[index])
      }
      triangles += (accessors[indices ?? attributes.POSITION]?.count ?? 0) / 3
    }
  }
  const largest = Math.max(stored, unpacked, used)
  if (largest > most) return `its meshes decode to ${megabytes(largest)}, more than ${megabytes(most)}`
  const mostTriangles = Math.max(TRIANGLES, TRIANGLES_PER_BYTE * fileBytes)
  if (triangles > mostTriangles) {
    return `it has ${Math.floor(triangles)} triangles in ${fileBytes} bytes, more than ${mostTriangles}`
  }
  return undefined
}

const megabytes = (bytes: number) => `${Math.ceil(bytes / 1e6)} MB`
