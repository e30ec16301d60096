import { FurrowError } from 'furrow'
import type { Skin } from 'furrow/author'
import { barycentricsAt, moveToFirstTile, type SkinSurface, skinSurface, UvLocator } from 'furrow/internal'
import { Vector3 } from 'three'
import type { MeshBVH } from 'three-mesh-bvh'
import { buildHierarchy } from './hierarchy.ts'
import { type PaintMap, type PaintMapArrays, paintMapArrays } from './paint-map.ts'

export interface SkinPoint {
  /** Index of the triangle in the surface. */
  triangle: number
  /** Position at rest, millimetres, in the frame of the surface. */
  position: readonly [x: number, y: number, z: number]
}

/**
 * Makes the surface of a skin at rest: its triangles, with positions in millimetres. The middle plane of a face is at x = 0.
 *
 * @param scale millimetres per unit of the skin's positions. Default: the scale that `skinSurface` estimates.
 * @throws FurrowError if the skin has only degenerate triangles or none, or if the scale is out of range.
 */
export function paintSurface(skin: Skin, scale?: number): SkinSurface {
  const { surface, scale: measured } = skinSurface(skin)
  if (surface.corners.length === 0) {
    throw new FurrowError({
      who: 'Studio',
      problem: 'the mesh has no triangles, or only degenerate ones',
      value: `${Math.floor(skin.indices.length / 3)} triangles`,
      remedy: 'check the mesh in the program that made it',
    })
  }
  if (scale !== undefined && !(scale > 0 && scale < Infinity)) {
    throw new FurrowError({
      code: 'out-of-range',
      who: 'Studio',
      problem: 'the number of millimetres per unit of the mesh is invalid',
      value: scale,
      limit: 'above 0',
      remedy: 'give 1000 for a mesh in metres',
    })
  }
  const factor = (scale ?? measured) / measured
  return { ...surface, points: surface.points.map((value) => factor * value) }
}

/** Skin that can be painted: its surface, and one map of texels for each resolution of painted areas. */
export class PaintSkin {
  readonly skin: Skin
  readonly surface: SkinSurface
  readonly #maps = new Map<number, PaintMap>()
  #hierarchy: MeshBVH | undefined

  /**
   * @param surface result of `paintSurface`.
   * @param map precomputed map of this skin and surface.
   */
  constructor(skin: Skin, surface: SkinSurface, map?: PaintMapArrays) {
    this.skin = moveToFirstTile(skin).skin
    this.surface = surface
    if (map) this.addMap(map)
  }

  hasMap(size: number): boolean {
    return this.#maps.has(size)
  }

  addMap(arrays: PaintMapArrays): PaintMap {
    const map = { ...arrays, locator: new UvLocator(this.skin, this.surface, arrays.grid) }
    this.#maps.set(arrays.size, map)
    return map
  }

  /** Returns the map of `size` x `size` texels. The map is cached. */
  mapOf(size: number): PaintMap {
    return this.#maps.get(size) ?? this.addMap(paintMapArrays(this.skin, this.surface, size))
  }

  /** Returns the skin point nearest to the mirror image of a position. */
  mirrored([x, y, z]: SkinPoint['position']): SkinPoint {
    const { points, corners } = this.surface
    this.#hierarchy ??= buildHierarchy(Float32Array.from(points), corners)
    const found = this.#hierarchy.closestPointToPoint(new Vector3(-x, y, z))
    // Not null, because the surface has at least one triangle.
    const { faceIndex, point } = found!
    return { triangle: faceIndex, position: [point.x, point.y, point.z] }
  }
}

/** Computes the barycentric coordinates of a position, clamped to the triangle. */
export function clampedBarycentrics(
  surface: SkinSurface,
  triangle: number,
  position: ArrayLike<number>,
  out: Float64Array,
): void {
  barycentricsAt(out, surface, triangle, position)
  let sum = 0
  for (let k = 0; k < 3; k++) {
    out[k] = Math.max(out[k], 0)
    sum += out[k]
  }
  for (let k = 0; k < 3; k++) out[k] /= sum
}
