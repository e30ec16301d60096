import type { Accessor, Document } from '@gltf-transform/core'

/**
 * Checks that the attributes of each primitive have as many elements as it has vertices, and that its indices are those
 * of vertices. Of compressed meshes only their decoder knows.
 *
 * @returns what is wrong, or undefined.
 */
export function meshProblem(document: Document): string | undefined {
  for (const [m, mesh] of document.getRoot().listMeshes().entries()) {
    for (const [p, primitive] of mesh.listPrimitives().entries()) {
      const where = `meshes[${m}].primitives[${p}]`
      const vertices = primitive.getAttribute('POSITION')?.getCount()
      if (vertices === undefined) continue
      for (const owner of [primitive, ...primitive.listTargets()]) {
        for (const name of owner.listSemantics()) {
          const count = owner.getAttribute(name)!.getCount()
          if (count !== vertices) return `${where} has ${count} elements of ${name} for ${vertices} vertices`
        }
      }
      const indices = primitive.getIndices()
      const last = indices ? largestOf(indices) : -1
      if (last >= vertices) return `${where} has the index ${last} of ${vertices} vertices`
    }
  }
  return undefined
}

function largestOf(indices: Accessor): number {
  let largest = 0
  for (const index of indices.getArray() ?? []) if (index > largest) largest = index
  return largest
}
