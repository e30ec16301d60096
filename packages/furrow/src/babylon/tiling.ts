import { VertexBuffer } from '@babylonjs/core/Buffers/buffer.js'
import type { BaseTexture } from '@babylonjs/core/Materials/Textures/baseTexture.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { Mesh } from '@babylonjs/core/Meshes/mesh.js'
import { isTiledBy, type UvRanges, uvRanges } from '../math/uv-ranges.ts'

/** Cached ranges of texture coordinates; null if the coordinates exist on the GPU only. */
const knownRanges = new WeakMap<VertexBuffer, UvRanges | null>()

/** Whether the texture coordinates of a map may wrap around on a mesh; see `isTiledBy`. */
export function isTiled(mesh: AbstractMesh, map: BaseTexture): boolean {
  const { coordinatesIndex } = map
  const kind = coordinatesIndex === 0 ? VertexBuffer.UVKind : `${VertexBuffer.UVKind}${coordinatesIndex + 1}`
  const buffer = (mesh as Mesh).getVertexBuffer?.(kind)
  if (!buffer) return false
  let ranges = knownRanges.get(buffer)
  if (ranges === undefined) {
    ranges = rangesOf(mesh.getVerticesData(kind))
    knownRanges.set(buffer, ranges)
  }
  if (!ranges) return true
  const { m } = map.getTextureMatrix()
  return isTiledBy(ranges, m[0], m[4], m[8], m[1], m[5], m[9])
}

function rangesOf(coordinates: ArrayLike<number> | null): UvRanges | null {
  return coordinates && uvRanges(coordinates.length / 2, (i, axis) => coordinates[2 * i + axis])
}
