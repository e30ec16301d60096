import type { Accessor, Material, Mesh, Node, Primitive } from '@gltf-transform/core'
import type { Skin } from 'furrow/author'
import { BufferAttribute, Matrix3, Matrix4 } from 'three'
import { namesOfTargets } from '../gltf/gltf-json.ts'
import { placementOf } from '../gltf/mesh-nodes.ts'
import { readCoordinates } from './coordinates.ts'

/**
 * Reads some primitives of a mesh as one skin in metres, in world space as its first node or skeleton places it.
 * Vertices that no triangle uses are left out: primitives often have all vertices of a mesh.
 */
export function readSkin(mesh: Mesh, primitives: readonly Primitive[], material: Material): Skin {
  const targets = Math.max(0, ...primitives.map((primitive) => primitive.listTargets().length))
  const names = namesOfTargets(mesh.getExtras().targetNames, targets)
  const parts = primitives.map((primitive) => ({ primitive, ...usedVertices(primitive) }))
  const total = parts.reduce((sum, { used }) => sum + used.length, 0)
  const positions = new Float32Array(3 * total)
  const uvs = new Float32Array(2 * total)
  const offsets = names.map(() => new Float32Array(3 * total))
  const indices = new Uint32Array(parts.reduce((sum, { corners }) => sum + corners.length, 0))
  let [first, corner] = [0, 0]
  for (const { primitive, used, corners } of parts) {
    copyInto(positions, primitive.getAttribute('POSITION')!, used, first)
    readCoordinates(primitive, material, used, uvs.subarray(2 * first))
    for (const [k, target] of primitive.listTargets().entries()) {
      const moved = target.getAttribute('POSITION')
      if (moved) copyInto(offsets[k], moved, used, first)
    }
    for (const vertex of corners) indices[corner++] = first + vertex
    first += used.length
  }
  const placement = placementOfMesh(mesh)
  if (placement) {
    new BufferAttribute(positions, 3).applyMatrix4(placement)
    const linear = new Matrix3().setFromMatrix4(placement)
    for (const offset of offsets) new BufferAttribute(offset, 3).applyMatrix3(linear)
  }
  return { positions, uvs, indices, targets: names.map((name, k) => ({ name, offsets: offsets[k] })) }
}

/** The index of a corner whose vertex does not exist; the skin is refused for it later. */
const NO_VERTEX = 2 ** 31

/** The vertices that triangles use, ascending, and each triangle's corners as indices into them. */
function usedVertices(primitive: Primitive): { used: Uint32Array; corners: Uint32Array } {
  const index = primitive.getIndices()
  const count = primitive.getAttribute('POSITION')!.getCount()
  const corners = Uint32Array.from({ length: index?.getCount() ?? count }, (_, k) => index?.getScalar(k) ?? k)
  const isUsed = new Uint8Array(count)
  for (const vertex of corners) isUsed[vertex] = 1
  const used = Uint32Array.from({ length: count }, (_, i) => i).filter((i) => isUsed[i] === 1)
  const newIndex = new Uint32Array(count)
  for (const [i, vertex] of used.entries()) newIndex[vertex] = i
  return { used, corners: corners.map((vertex) => (vertex < count ? newIndex[vertex] : NO_VERTEX)) }
}

/** Undefined where it is the identity. */
function placementOfMesh(mesh: Mesh): Matrix4 | undefined {
  const node = mesh.listParents().find((parent) => parent.propertyType === 'Node') as Node | undefined
  const placement = new Matrix4()
  if (node) placement.fromArray(placementOf(node))
  return placement.equals(new Matrix4()) ? undefined : placement
}

/** Copies vectors of the used vertices, whatever the accessor's type. */
function copyInto(out: Float32Array, accessor: Accessor, used: Uint32Array, first: number): void {
  const element: number[] = []
  for (const [i, vertex] of used.entries()) {
    accessor.getElement(vertex, element)
    for (let k = 0; k < 3; k++) out[3 * (first + i) + k] = element[k]
  }
}
