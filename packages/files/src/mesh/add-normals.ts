import type { Document, Primitive } from '@gltf-transform/core'
import { weldVertices } from 'furrow/internal'
import { Vector3 } from 'three'
import { BufferViewWriter } from '../gltf/buffer-view-writer.ts'
import type { Glb } from '../gltf/glb.ts'
import { trianglesOf } from './mesh-nodes.ts'

const FLOAT = 5126

/**
 * Adds smooth normals to those primitives of a mesh that have no normals. Without normals, renderers shade flat and
 * show no wrinkles.
 *
 * @param glb changed in place. Existing indices stay valid.
 * @param document `glb`, decoded.
 * @param mesh index of the mesh.
 * @returns number of primitives that got normals.
 */
export function addNormals(glb: Glb, document: Document, mesh: number): number {
  const { json } = glb
  const decoded = document.getRoot().listMeshes()[mesh]
  const usable = trianglesOf(decoded)
  const written = json.meshes![mesh].primitives
  const missing = [...decoded.listPrimitives().entries()].filter(
    ([, primitive]) => usable.includes(primitive) && !primitive.getAttribute('NORMAL'),
  )
  if (missing.length === 0) return 0
  const views = new BufferViewWriter(glb)
  json.accessors ??= []
  for (const [i, primitive] of missing) {
    const normals = smoothNormals(primitive)
    const bufferView = views.add(new Uint8Array(normals.buffer))
    const accessor = { bufferView, componentType: FLOAT, type: 'VEC3', count: normals.length / 3 }
    written[i].attributes!.NORMAL = json.accessors.push(accessor) - 1
  }
  views.finish()
  return missing.length
}

/**
 * Computes unit vertex normals from the area-weighted normals of adjacent triangles. Vertices at the same position
 * share a normal.
 */
function smoothNormals(primitive: Primitive): Float32Array<ArrayBuffer> {
  const position = primitive.getAttribute('POSITION')!
  const count = position.getCount()
  const at = Array.from({ length: count }, (_, i) => new Vector3().fromArray(position.getElement(i, [])))
  const { pointOf, count: points } = weldVertices(at.flatMap((vertex) => vertex.toArray()))
  const sums = Array.from({ length: points }, () => new Vector3())
  const indices = primitive.getIndices()?.getArray() ?? [...at.keys()]
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const [a, b, c] = [indices[t], indices[t + 1], indices[t + 2]]
    const normal = at[b].clone().sub(at[a]).cross(at[c].clone().sub(at[a]))
    for (const vertex of [a, b, c]) sums[pointOf[vertex]].add(normal)
  }
  const normals = new Float32Array(3 * count)
  for (let i = 0; i < count; i++) {
    const normal = sums[pointOf[i]].clone().normalize()
    // A vertex without triangles gets an arbitrary unit normal.
    if (!(normal.lengthSq() > 0)) normal.set(0, 0, 1)
    normal.toArray(normals, 3 * i)
  }
  return normals
}
