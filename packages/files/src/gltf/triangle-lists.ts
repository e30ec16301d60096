import { type Accessor, type Document, Primitive } from '@gltf-transform/core'

const { TRIANGLE_STRIP, TRIANGLE_FAN } = Primitive.Mode

/** Maximum number of triangles in all strips and fans of a file. */
const MAX_TRIANGLES = 4_000_000

/**
 * Converts triangle strips and fans to triangle lists. Drops degenerate triangles.
 *
 * @returns error text, or undefined.
 */
export function listTriangles(document: Document): string | undefined {
  /**
   * Index accessor of each converted list. The key is the accessor of the indices. If there are none, it is the
   * accessor of the positions.
   */
  const lists = {
    [TRIANGLE_STRIP]: new Map<Accessor, Accessor>(),
    [TRIANGLE_FAN]: new Map<Accessor, Accessor>(),
  }
  let total = 0
  for (const primitive of document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives())) {
    const mode = primitive.getMode()
    const order = primitive.getIndices() ?? primitive.getAttribute('POSITION')
    if ((mode !== TRIANGLE_STRIP && mode !== TRIANGLE_FAN) || !order) continue
    let list = lists[mode].get(order)
    if (!list) {
      total += order.getCount()
      if (total > MAX_TRIANGLES) {
        return `its strips and fans have more than ${MAX_TRIANGLES.toLocaleString('en')} triangles`
      }
      const corners = cornersOf(mode, order.getCount(), primitive.getIndices()?.getArray())
      list = document.createAccessor().setArray(corners)
      lists[mode].set(order, list)
    }
    primitive.setIndices(list).setMode(Primitive.Mode.TRIANGLES)
  }
  return undefined
}

/** Returns three vertex indices per triangle, in the order of glTF 2.0 (3.7.2.1). */
function cornersOf(mode: number, count: number, indices: ArrayLike<number> | null | undefined): Uint32Array {
  const corners = new Uint32Array(3 * Math.max(0, count - 2))
  let length = 0
  for (let i = 0; i + 2 < count; i++) {
    const places = mode === TRIANGLE_FAN ? [i + 1, i + 2, 0] : [i, i + 1 + (i % 2), i + 2 - (i % 2)]
    const [a, b, c] = indices ? places.map((place) => indices[place]) : places
    if (a === b || b === c || c === a) continue
    corners.set([a, b, c], length)
    length += 3
  }
  return corners.slice(0, length)
}
