import type { BakeMesh } from 'furrow/author'
import { generateTangents } from 'mikktspace'
import type { ReadOptions } from '../disk/external-files.ts'
import { readDocument } from '../gltf/read-document.ts'
import { pickMesh } from '../mesh/face-mesh.ts'
import { nameOf } from '../mesh/mesh-nodes.ts'
import { lowMeshOf } from './low-mesh.ts'
import { type Surface, surfaceOf } from './surface.ts'
import { meshError } from './vertices.ts'

const WHO = 'furrow bake'

/** Method to compute tangents that a mesh lacks: MikkTSpace, or screen-space derivatives in the shader. */
export type Tangents = 'mikktspace' | 'derivative'

/** Reads the high-poly surface. Throws if the file cannot be read. */
export async function readSurface(path: string, options: ReadOptions = {}): Promise<Surface> {
  return surfaceOf(await readDocument(path, WHO, options), path, WHO)
}

/** Reads the low-poly mesh. Throws if the file cannot be read. */
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

/** Computes tangents with MikkTSpace. Negates w, because v points up in MikkTSpace and down in glTF. */
function mikktspace({ positions, normals, uvs }: BakeMesh, path: string): Float32Array {
  let tangents: Float32Array
  try {
    tangents = generateTangents(positions, normals, uvs)
  } catch {
    // `generateTangents` traps if all triangles are degenerate.
    throw meshError(
      WHO,
      `cannot compute tangents for ${path}`,
      'triangles with nonzero area',
      'export the mesh again',
    )
  }
  for (let i = 3; i < tangents.length; i += 4) tangents[i] *= -1
  return tangents
}
