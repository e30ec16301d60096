import type { Node, Primitive } from '@gltf-transform/core'
import type { BakeMesh } from 'furrow/author'
import { nameOf, trianglesOf } from '../mesh/mesh-nodes.ts'
import {
  checkFinite,
  cornersOf,
  join,
  matrixOf,
  meshError,
  noTriangles,
  readAttribute,
  transform,
} from './vertices.ts'

/**
 * Default maximum distance between the low-poly mesh and the sculpt, as a fraction of the low-poly mesh's bounding box
 * diagonal.
 */
export const DEFAULT_CAGE = 0.02

/**
 * Reads the low-poly mesh of a normal map bake, with three vertices per triangle. Tangents that the mesh lacks come
 * from `computeTangents`, if it is given.
 *
 * @throws FurrowError if the mesh has no texture coordinates or no normals.
 */
export function lowMeshOf(
  node: Node,
  path: string,
  who: string,
  computeTangents?: (mesh: BakeMesh) => Float32Array,
): { mesh: BakeMesh; hasTangents: boolean } {
  const parts = trianglesOf(node.getMesh()!)
  if (!parts.every((primitive) => primitive.getAttribute('NORMAL'))) {
    throw meshError(
      who,
      `${nameOf(node)} in ${path} has no normals`,
      'smooth normals',
      'export the low mesh with normals',
    )
  }
  const hasTangents = parts.every((primitive) => primitive.getAttribute('TANGENT'))
  const meshes = parts.map((primitive) => {
    const mesh = readUnindexed(primitive, path, who)
    if (hasTangents) mesh.tangents = perCorner(primitive, 'TANGENT', 4)
    else if (computeTangents) mesh.tangents = computeTangents(mesh)
    return mesh
  })
  if (meshes.every(({ positions }) => positions.length === 0)) throw noTriangles(path, who)
  for (const mesh of meshes) transform(mesh, matrixOf(node))
  const joined = (name: 'positions' | 'normals' | 'uvs') =>
    join(
      Float32Array,
      meshes.map((part) => part[name]),
    )
  const mesh: BakeMesh = { positions: joined('positions'), normals: joined('normals'), uvs: joined('uvs') }
  const partTangents = meshes.flatMap((part) => part.tangents ?? [])
  if (partTangents.length > 0) mesh.tangents = join(Float32Array, partTangents)
  checkFinite(mesh.positions, path, who)
  checkFinite(mesh.normals, path, who)
  return { mesh, hasTangents }
}

function readUnindexed(primitive: Primitive, path: string, who: string): BakeMesh {
  const mesh: BakeMesh = {
    positions: perCorner(primitive, 'POSITION', 3),
    normals: perCorner(primitive, 'NORMAL', 3),
    uvs: perCorner(primitive, 'TEXCOORD_0', 2),
  }
  for (const values of [mesh.positions, mesh.normals, mesh.uvs]) checkFinite(values, path, who)
  return mesh
}

function perCorner(primitive: Primitive, name: string, size: number): Float32Array {
  const corners = cornersOf(primitive, false)
  const values = readAttribute(primitive, name, size)
  const out = new Float32Array(size * corners.length)
  for (let i = 0; i < corners.length; i++) {
    for (let k = 0; k < size; k++) out[size * i + k] = values[size * corners[i] + k]
  }
  return out
}
