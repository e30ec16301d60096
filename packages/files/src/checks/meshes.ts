import type { Accessor, Document } from '@gltf-transform/core'

/**
 * Checks that all attributes of a primitive have the same count, and that its indices are in range. Call it after
 * decoding, because the counts of compressed meshes are unknown before.
 *
 * @returns error text, or undefined.
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
      const last = indices ? maxIndex(indices) : -1
      if (last >= vertices) return `${where} has the index ${last}, but only ${vertices} vertices`
    }
  }
  return undefined
}

function maxIndex(indices: Accessor): number {
  let largest = 0
  for (const index of indices.getArray() ?? []) if (index > largest) largest = index
  return largest
}
