import type { Accessor, Material, Mesh, Primitive } from '@gltf-transform/core'
import type { Skin } from 'furrow/author'
import { joinParts, type SkinPart } from 'furrow/internal'
import { Matrix4 } from 'three'
import { namesOfTargets } from '../json/gltf-json.ts'
import { readCoordinates } from './coordinates.ts'
import { type HeadReader, headReader } from './head-weights.ts'
import { nodeOf, placementOf } from './mesh-nodes.ts'
import { influencesOf, type JointReader } from './read-skeleton.ts'

/**
 * Reads primitives of a mesh as one surface, in metres in world space. If several nodes place the mesh, uses the first.
 *
 * @param expressions names of VRM expressions that move a single morph target, by index of the target.
 * @param joints result of `jointReader` for the file.
 */
export function readSkin(
  mesh: Mesh,
  primitives: readonly Primitive[],
  material: Material,
  expressions: ReadonlyMap<number, string>,
  joints: JointReader,
): Skin {
  const targets = Math.max(0, ...primitives.map((primitive) => primitive.listTargets().length))
  const names = namesOfTargets(mesh.getExtras().targetNames, targets)
  const head = headReader(mesh)
  const parts = primitives.map((primitive) => partOf(primitive, material, head))
  const placement = placementOfMesh(mesh)
  return joinParts(parts, names, placement, expressions, joints(mesh, placement))
}

function partOf(primitive: Primitive, material: Material, head: HeadReader | undefined): SkinPart {
  const positions = primitive.getAttribute('POSITION')!
  const index = primitive.getIndices()
  const targets = primitive.listTargets()
  const count = positions.getCount()
  return {
    count,
    indices: indicesOf(index, count),
    readPositions: (vertices, out) => copyInto(out, positions, vertices),
    readUvs: (vertices, out) => readCoordinates(primitive, material, vertices, out),
    readHeadWeights: head && ((vertices, out) => head(primitive, vertices, out)),
    influences: influencesOf(primitive),
    readOffsets(k, vertices, out) {
      const moved = targets[k]?.getAttribute('POSITION')
      if (moved) copyInto(out, moved, vertices)
    },
  }
}

/** Returns the matrix from mesh to world space. Returns undefined for the identity. */
function placementOfMesh(mesh: Mesh): number[] | undefined {
  const node = nodeOf(mesh)
  const placement = new Matrix4()
  if (node) placement.fromArray(placementOf(node))
  return placement.equals(new Matrix4()) ? undefined : placement.toArray()
}

/** Returns the vertex indices of a primitive. A primitive without indices uses its vertices in order. */
function indicesOf(index: Accessor | null, count: number): Uint32Array {
  const array = index?.getArray()
  if (array) return new Uint32Array(array)
  return Uint32Array.from({ length: count }, (_, k) => k)
}

/** Copies vectors of the given vertices from an accessor of any type. */
function copyInto(out: Float32Array, accessor: Accessor, vertices: Uint32Array): void {
  const array = accessor.getArray()
  // `getElement` also dequantises integers, but takes six times as long as this copy.
  if (array instanceof Float32Array) {
    for (let i = 0; i < vertices.length; i++)
      for (let k = 0; k < 3; k++) out[3 * i + k] = array[3 * vertices[i] + k]
    return
  }
  const element: number[] = []
  for (let i = 0; i < vertices.length; i++) {
    accessor.getElement(vertices[i], element)
    for (let k = 0; k < 3; k++) out[3 * i + k] = element[k]
  }
}
