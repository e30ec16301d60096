import type { Material, Mesh, MeshStandardMaterial } from 'three'
import { isTiledBy, type UvRanges, uvRanges } from '../../math/uv-ranges.ts'
import { type AnyAttribute, componentOf } from '../sources/geometry-arrays.ts'

/**
 * Tells whether the shader of a face must support tiled maps. A map is tiled if texture coordinates leave 0..1, so that neighbouring pixels
 * may sample opposite edges of the map.
 */
export interface Tiling {
  readonly isTiled: boolean
  /** Whether the shader can also draw another mesh: true if the shader supports tiled maps, or the mesh does not tile its map. */
  supportsMesh(mesh: Mesh): boolean
  /** Whether the shader can still draw all meshes. The page may have changed the transform of the normal map. */
  isCurrent(): boolean
}

/**
 * Finds out whether any mesh of a face tiles its normal map.
 *
 * @param meshes meshes of the face. The list may grow.
 */
export function tilingOf(meshes: readonly Mesh[], material: Material): Tiling {
  const matrixOf = () => (material as MeshStandardMaterial).normalMap!.matrix
  const supportsMesh = (mesh: Mesh) => wasTiled || !isTiled(mesh, material)
  let wasTiled = false
  wasTiled = !meshes.every(supportsMesh)
  const known = matrixOf().clone()
  return {
    isTiled: wasTiled,
    supportsMesh,
    isCurrent() {
      if (matrixOf().equals(known)) return true
      known.copy(matrixOf())
      return meshes.every(supportsMesh)
    },
  }
}

/** Whether a mesh tiles its normal map; see `isTiledBy`. */
export function isTiled({ geometry }: Mesh, material: Material): boolean {
  const map = (material as MeshStandardMaterial).normalMap!
  if (map.matrixAutoUpdate) map.updateMatrix()
  const ranges = rangesOf(geometry.getAttribute(map.channel ? `uv${map.channel}` : 'uv'))
  const [a, d, , b, e, , c, f] = map.matrix.elements
  return isTiledBy(ranges, a, b, c, d, e, f)
}

const knownRanges = new WeakMap<AnyAttribute, UvRanges>()

/** Returns the UV ranges of an attribute. Cached, because the meshes of a crowd share one attribute. */
function rangesOf(attribute: AnyAttribute): UvRanges {
  const ranges =
    knownRanges.get(attribute) ?? uvRanges(attribute.count, (i, axis) => componentOf(attribute, i, axis))
  knownRanges.set(attribute, ranges)
  return ranges
}
