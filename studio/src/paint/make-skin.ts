import type { Skin } from 'furrow/author'
import { moveToFirstTile, type SkinSurface } from 'furrow/internal'
import { MeshBVH, type SerializedBVH } from 'three-mesh-bvh'
import { hierarchyOf } from './hierarchy.ts'
import { type PaintMapArrays, paintMapArrays } from './paint-map.ts'
import { paintSurface } from './paint-skin.ts'

/** What tools need to know of a skin, as arrays that a worker can hand over. */
export interface MadeSkin {
  /** Of `paintSurface`. */
  readonly surface: SkinSurface
  /** Of the areas, where their size was given. */
  readonly map: PaintMapArrays | undefined
  /** Three vertices per triangle of the skin; those that the surface has not, which may have no positions, are one point of it. */
  readonly indices: Uint32Array
  /** Of these triangles at rest. */
  readonly hierarchy: SerializedBVH
}

/**
 * @param scale millimetres per unit of the skin's positions.
 * @param size side of the areas in texels.
 * @throws FurrowError when the skin cannot be painted.
 */
export function makeSkin(skin: Skin, scale?: number, size?: number): MadeSkin {
  const surface = paintSurface(skin, scale)
  const map = size === undefined ? undefined : paintMapArrays(moveToFirstTile(skin).skin, surface, size)
  const indices = surfaceIndices(skin, surface)
  const hierarchy = hierarchyOf(Float32Array.from(skin.positions), indices)
  return { surface, map, indices, hierarchy: MeshBVH.serialize(hierarchy, { cloneBuffers: false }) }
}

function surfaceIndices({ indices }: Skin, { skinTriangles }: SkinSurface): Uint32Array {
  const out = new Uint32Array(indices.length).fill(indices[3 * skinTriangles[0]])
  for (const triangle of skinTriangles) {
    for (let i = 3 * triangle; i < 3 * triangle + 3; i++) out[i] = indices[i]
  }
  return out
}
