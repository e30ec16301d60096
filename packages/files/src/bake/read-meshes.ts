import type { BakeMesh } from 'furrow/author'
import { generateTangents } from 'mikktspace'
import type { ReadOptions } from '../disk/external-files.ts'
import { readDocument } from '../gltf/read-document.ts'
import { pickMesh } from '../mesh/face-mesh.ts'
import { nameOf } from '../mesh/mesh-nodes.ts'
import { lowMeshOf } from './low-mesh.ts'
import { type Surface, surfaceOf } from './surface.ts'
import { fault } from './vertices.ts'

const WHO = 'furrow bake'

/** Tangents of a mesh without tangents of its own: see TangentFrame. */
export type Tangents = 'mikktspace' | 'derivative'

/** Reads the detailed surface; see `surfaceOf`. Throws FurrowError if it cannot be read. */
export async function readSurface(path: string, options: ReadOptions = {}): Promise<Surface> {
  return surfaceOf(await readDocument(path, WHO, options), path, WHO)
}

/** Reads the mesh that the maps are for; see `lowMeshOf` and `pickMesh`. Throws FurrowError if it cannot be read. */
export async function readLow(
  path: string,
  meshName: string | undefined,
  tangents: Tangents,
  options: ReadOptions = {},
): Promise<{ name: string; mesh: BakeMesh; tangents: 'of the mesh' | Tangents }> {
  const node = pickMesh(await readDocument(path, WHO, options), path, WHO, meshName)
  const compute = tangents === 'mikktspace' ? (mesh: BakeMesh) => mikktspace(mesh, path) : undefined
  const { mesh, hasTangents } = lowMeshOf(node, path, WHO, compute)
  return { name: nameOf(node), mesh, tangents: hasTangents ? 'of the mesh' : tangents }
}

/** MikkTSpace's v points up, glTF's down, which negates w. */
function mikktspace({ positions, normals, uvs }: BakeMesh, path: string): Float32Array {
  let tangents: Float32Array
  try {
    tangents = generateTangents(positions, normals, uvs)
  } catch {
    // Its WebAssembly traps where no triangle is left that has an area.
    throw fault(
      WHO,
      `no tangents can be computed for ${path}`,
      'triangles with an area',
      'export the mesh again',
    )
  }
  for (let i = 3; i < tangents.length; i += 4) tangents[i] *= -1
  return tangents
}
