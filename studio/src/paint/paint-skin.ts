import { FurrowError } from 'furrow'
import type { Skin } from 'furrow/author'
import { barycentricsAt, moveToFirstTile, type SkinSurface, skinSurface, UvLocator } from 'furrow/internal'
import { Vector3 } from 'three'
import type { MeshBVH } from 'three-mesh-bvh'
import { hierarchyOf } from './hierarchy.ts'
import { type PaintMap, type PaintMapArrays, paintMapArrays } from './paint-map.ts'

/** A point on a skin. */
export interface SkinPoint {
  /** Of the surface. */
  triangle: number
  /** At rest, in millimetres in the frame of the surface. */
  position: readonly [x: number, y: number, z: number]
}

/**
 * The surface of a skin at rest, in millimetres; of a face in its own frame, whose x = 0 is its middle.
 *
 * @param scale millimetres per unit of the skin's positions; by default a face is measured by the distance of its eyes.
 * @throws FurrowError when the skin has no triangle.
 */
export function paintSurface(skin: Skin, scale?: number): SkinSurface {
  const { surface, scale: measured } = skinSurface(skin)
  if (surface.corners.length === 0) {
    throw new FurrowError({
      who: 'Studio',
      problem: 'no triangle of the mesh has an area that could be painted',
      value: `${Math.floor(skin.indices.length / 3)} triangles`,
      remedy: 'check the mesh in the program that made it',
    })
  }
  if (scale !== undefined && !(scale > 0 && scale < Infinity)) {
    throw new FurrowError({
      code: 'out-of-range',
      who: 'Studio',
      problem: 'millimetres per unit of the mesh',
      value: scale,
      limit: 'above 0',
      remedy: 'give 1000 for a mesh in metres',
    })
  }
  const factor = (scale ?? measured) / measured
  return { ...surface, points: surface.points.map((value) => factor * value) }
}

/** A skin that is painted on: its surface, and the maps of it. */
export class PaintSkin {
  readonly skin: Skin
  readonly surface: SkinSurface
  readonly #maps = new Map<number, PaintMap>()
  #hierarchy: MeshBVH | undefined

  /**
   * @param surface of `paintSurface`.
   * @param map one that was made of them before.
   */
  constructor(skin: Skin, surface: SkinSurface, map?: PaintMapArrays) {
    this.skin = moveToFirstTile(skin).skin
    this.surface = surface
    if (map) this.addMap(map)
  }

  hasMap(size: number): boolean {
    return this.#maps.has(size)
  }

  /** Takes a map that was made of the same skin and surface elsewhere. */
  addMap(arrays: PaintMapArrays): PaintMap {
    const map = { ...arrays, locator: new UvLocator(this.skin, this.surface, arrays.grid) }
    this.#maps.set(arrays.size, map)
    return map
  }

  /** The texels of a map of size x size, which are found once. */
  mapOf(size: number): PaintMap {
    return this.#maps.get(size) ?? this.addMap(paintMapArrays(this.skin, this.surface, size))
  }

  /** The point of the skin that is nearest to where a position is on the other side of the face. */
  mirrored([x, y, z]: SkinPoint['position']): SkinPoint {
    const { points, corners } = this.surface
    this.#hierarchy ??= hierarchyOf(Float32Array.from(points), corners)
    const found = this.#hierarchy.closestPointToPoint(new Vector3(-x, y, z))
    // The surface has at least one triangle.
    const { faceIndex, point } = found!
    return { triangle: faceIndex, position: [point.x, point.y, point.z] }
  }
}

/** Barycentric coordinates in a triangle, moved onto it from beyond its edges. */
export function weightsOn(
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
