import { VertexBuffer } from '@babylonjs/core/Buffers/buffer.js'
import type { BaseTexture } from '@babylonjs/core/Materials/Textures/baseTexture.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { Mesh } from '@babylonjs/core/Meshes/mesh.js'

type Range = [least: number, largest: number]

/** Of u and v; found once for all meshes with the same texture coordinates. */
const knownRanges = new WeakMap<VertexBuffer, [Range, Range]>()

/**
 * Whether texture coordinates leave 0..1 somewhere on a mesh, and so wrap: neighbouring pixels may then be at opposite edges of its maps.
 * True of all that a rotated map may have so.
 */
export function isTiled(mesh: AbstractMesh, map: BaseTexture): boolean {
  const { coordinatesIndex } = map
  const kind = coordinatesIndex === 0 ? VertexBuffer.UVKind : `${VertexBuffer.UVKind}${coordinatesIndex + 1}`
  const buffer = (mesh as Mesh).getVertexBuffer?.(kind)
  if (!buffer) return false
  const ranges = knownRanges.get(buffer) ?? rangesOf(mesh.getVerticesData(kind)!)
  knownRanges.set(buffer, ranges)
  const matrix = map.getTextureMatrix()
  if (matrix.isIdentityAs3x2()) return ranges.some(([least, largest]) => least < 0 || largest > 1)
  const [us, vs] = ranges
  return us.some((u) =>
    vs.some((v) => {
      const { x, y } = Vector3.TransformCoordinates(new Vector3(u, v, 1), matrix)
      return Math.min(x, y) < 0 || Math.max(x, y) > 1
    }),
  )
}

function rangesOf(coordinates: ArrayLike<number>): [Range, Range] {
  const ranges: [Range, Range] = [
    [Infinity, -Infinity],
    [Infinity, -Infinity],
  ]
  for (let i = 0; i < coordinates.length; i++) {
    const range = ranges[i % 2]
    range[0] = Math.min(range[0], coordinates[i])
    range[1] = Math.max(range[1], coordinates[i])
  }
  return ranges
}
