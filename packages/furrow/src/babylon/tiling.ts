import { VertexBuffer } from '@babylonjs/core/Buffers/buffer.js'
import type { BaseTexture } from '@babylonjs/core/Materials/Textures/baseTexture.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { Mesh } from '@babylonjs/core/Meshes/mesh.js'
import { isTiledBy, type UvRanges, uvRanges } from '../runtime/uv-ranges.ts'

/** Found once for all meshes with the same texture coordinates. */
const knownRanges = new WeakMap<VertexBuffer, UvRanges>()

/** Whether the texture coordinates of a map wrap somewhere on a mesh, see `isTiledBy`. */
export function isTiled(mesh: AbstractMesh, map: BaseTexture): boolean {
  const { coordinatesIndex } = map
  const kind = coordinatesIndex === 0 ? VertexBuffer.UVKind : `${VertexBuffer.UVKind}${coordinatesIndex + 1}`
  const buffer = (mesh as Mesh).getVertexBuffer?.(kind)
  if (!buffer) return false
  const ranges = knownRanges.get(buffer) ?? rangesOf(mesh.getVerticesData(kind)!)
  knownRanges.set(buffer, ranges)
  const matrix = map.getTextureMatrix()
  // Babylon.js has the offset in the third row.
  return isTiledBy(ranges, (u, v) => Vector3.TransformCoordinates(new Vector3(u, v, 1), matrix))
}

function rangesOf(coordinates: ArrayLike<number>): UvRanges {
  return uvRanges(coordinates.length / 2, (i, axis) => coordinates[2 * i + axis])
}
