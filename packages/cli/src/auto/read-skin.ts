import type { Accessor, Material, Mesh, Node, Primitive } from '@gltf-transform/core'
import { joinParts, type Skin, type SkinPart } from 'furrow/author'
import { Matrix4 } from 'three'
import { namesOfTargets } from '../gltf/gltf-json.ts'
import { placementOf } from '../gltf/mesh-nodes.ts'
import { readCoordinates } from './coordinates.ts'

/** Reads some primitives of a mesh as one skin in metres, in world space as its first node or skeleton places it. */
export function readSkin(mesh: Mesh, primitives: readonly Primitive[], material: Material): Skin {
  const targets = Math.max(0, ...primitives.map((primitive) => primitive.listTargets().length))
  const names = namesOfTargets(mesh.getExtras().targetNames, targets)
  const parts = primitives.map((primitive) => partOf(primitive, material))
  return joinParts(parts, names, placementOfMesh(mesh))
}

function partOf(primitive: Primitive, material: Material): SkinPart {
  const positions = primitive.getAttribute('POSITION')!
  const index = primitive.getIndices()
  const targets = primitive.listTargets()
  const count = positions.getCount()
  return {
    count,
    indices: Uint32Array.from({ length: index?.getCount() ?? count }, (_, k) => index?.getScalar(k) ?? k),
    readPositions: (vertices, out) => copyInto(out, positions, vertices),
    readUvs: (vertices, out) => readCoordinates(primitive, material, vertices, out),
    readOffsets(k, vertices, out) {
      const moved = targets[k]?.getAttribute('POSITION')
      if (moved) copyInto(out, moved, vertices)
    },
  }
}

/** Undefined where it is the identity. */
function placementOfMesh(mesh: Mesh): number[] | undefined {
  const node = mesh.listParents().find((parent) => parent.propertyType === 'Node') as Node | undefined
  const placement = new Matrix4()
  if (node) placement.fromArray(placementOf(node))
  return placement.equals(new Matrix4()) ? undefined : placement.toArray()
}

/** Copies vectors of some vertices, whatever the accessor's type. */
function copyInto(out: Float32Array, accessor: Accessor, vertices: Uint32Array): void {
  const element: number[] = []
  for (const [i, vertex] of vertices.entries()) {
    accessor.getElement(vertex, element)
    for (let k = 0; k < 3; k++) out[3 * i + k] = element[k]
  }
}
