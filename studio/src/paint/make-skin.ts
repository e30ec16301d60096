import type { Skin } from 'furrow/author'
import { moveToFirstTile, type SkinSurface } from 'furrow/internal'
import { MeshBVH, type SerializedBVH } from 'three-mesh-bvh'
import { buildHierarchy } from './hierarchy.ts'
import { type PaintMapArrays, paintMapArrays } from './paint-map.ts'
import { paintSurface } from './paint-skin.ts'

/** Skin data for the tools, as arrays that can be transferred between workers. */
export interface SkinData {
  /** Result of `paintSurface`. */
  readonly surface: SkinSurface
  /** Texels of the areas, if their size was given. */
  readonly map: PaintMapArrays | undefined
  /** Vertex indices of all triangles of the skin. A triangle that is not in the surface, such as a degenerate one, has three equal indices. */
  readonly indices: Uint32Array
  /** Bounding volume hierarchy of these triangles at rest. */
  readonly hierarchy: SerializedBVH
}

/**
 * Prepares a skin for the tools.
 *
 * @param scale millimetres per unit of the skin's positions.
 * @param size width and height of the areas, texels.
 * @throws FurrowError if the skin cannot be painted.
 */
export function makeSkin(skin: Skin, scale?: number, size?: number): SkinData {
  const surface = paintSurface(skin, scale)
  const map = size === undefined ? undefined : paintMapArrays(moveToFirstTile(skin).skin, surface, size)
  const indices = surfaceIndices(skin, surface)
  const hierarchy = buildHierarchy(Float32Array.from(skin.positions), indices)
  return { surface, map, indices, hierarchy: MeshBVH.serialize(hierarchy, { cloneBuffers: false }) }
}

function surfaceIndices({ indices }: Skin, { skinTriangles }: SkinSurface): Uint32Array {
  const out = new Uint32Array(indices.length).fill(indices[3 * skinTriangles[0]])
  for (const triangle of skinTriangles) {
    for (let i = 3 * triangle; i < 3 * triangle + 3; i++) out[i] = indices[i]
  }
  return out
}
