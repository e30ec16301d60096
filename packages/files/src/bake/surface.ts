import { type Document, Primitive } from '@gltf-transform/core'
import {
  checkFinite,
  cornersOf,
  isMirroring,
  join,
  matrixOf,
  noTriangles,
  readAttribute,
  transform,
} from './vertices.ts'

/** High-poly surface in world space, metres. */
export interface Surface {
  /** Packed xyz positions. */
  positions: Float32Array
  /** Packed xyz normals. Absent if any mesh has no normals: the whole surface is then flat-shaded. */
  normals?: Float32Array
  /** Three vertex indices per triangle. */
  indices: Uint32Array
}

/** Joins all triangles of a document, in rest pose and without blendshapes. Throws if there are none. */
export function surfaceOf(document: Document, path: string, who: string): Surface {
  const parts = document
    .getRoot()
    .listNodes()
    .flatMap((node) => (node.getMesh()?.listPrimitives() ?? []).map((primitive) => ({ node, primitive })))
    .filter(({ primitive }) => {
      return primitive.getMode() === Primitive.Mode.TRIANGLES && primitive.getAttribute('POSITION')
    })
  const isSmooth = parts.every(({ primitive }) => primitive.getAttribute('NORMAL'))
  const positions: Float32Array[] = []
  const normals: Float32Array[] = []
  const indices: Uint32Array[] = []
  let first = 0
  for (const { node, primitive } of parts) {
    const matrix = matrixOf(node)
    const part = {
      positions: readAttribute(primitive, 'POSITION', 3),
      normals: isSmooth ? readAttribute(primitive, 'NORMAL', 3) : undefined,
    }
    transform(part, matrix)
    positions.push(part.positions)
    if (part.normals) normals.push(part.normals)
    indices.push(cornersOf(primitive, isMirroring(matrix)).map((vertex) => first + vertex))
    first += part.positions.length / 3
  }
  const surface: Surface = {
    positions: join(Float32Array, positions),
    indices: join(Uint32Array, indices),
    ...(isSmooth && { normals: join(Float32Array, normals) }),
  }
  if (surface.indices.length === 0) throw noTriangles(path, who)
  checkFinite(surface.positions, path, who)
  return surface
}
