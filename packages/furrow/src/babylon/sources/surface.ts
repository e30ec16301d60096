import { VertexBuffer } from '@babylonjs/core/Buffers/buffer.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { SampledMesh } from '../../drivers/tension/samples.ts'
import type { SkinMaterial } from '../check-mesh.ts'

export function vertexData(mesh: AbstractMesh, kind: string): Float32Array {
  return Float32Array.from(mesh.getVerticesData(kind) ?? [])
}

/** Returns the vertex indices of all triangles. If the mesh has no indices, returns 0, 1, 2 and so on. */
export function trianglesOf(mesh: AbstractMesh): ArrayLike<number> {
  return mesh.getIndices() ?? Uint32Array.from({ length: mesh.getTotalVertices() }, (_, i) => i)
}

/** Returns the mesh at rest with the texture coordinates of areas of influence: those of the normal map, after the map's transform. */
export function sampledMesh(mesh: AbstractMesh): SampledMesh {
  const { bumpTexture } = mesh.material as SkinMaterial
  const set = bumpTexture?.coordinatesIndex ?? 0
  const uvs = vertexData(mesh, set === 0 ? VertexBuffer.UVKind : `uv${set + 1}`)
  const matrix = bumpTexture?.getTextureMatrix().m
  if (matrix) {
    for (let i = 0; i < uvs.length; i += 2) {
      const [u, v] = [uvs[i], uvs[i + 1]]
      uvs[i] = matrix[0] * u + matrix[4] * v + matrix[8]
      uvs[i + 1] = matrix[1] * u + matrix[5] * v + matrix[9]
    }
  }
  return { positions: vertexData(mesh, VertexBuffer.PositionKind), uvs, triangles: trianglesOf(mesh) }
}
