import type { Material, Mesh, MeshStandardMaterial } from 'three'
import { isTiledBy, type UvRanges, uvRanges } from '../../math/uv-ranges.ts'
import { type AnyAttribute, componentOf } from '../sources/geometry-arrays.ts'

/** Whether the shader of a face supports texture coordinates that wrap. */
export interface Tiling {
  readonly isTiled: boolean
  /** Whether the shader supports another mesh of the face. */
  supportsMesh(mesh: Mesh): boolean
  /** Whether the shader still supports all meshes, after the page changed the transform of the normal map. */
  isCurrent(): boolean
}

/**
 * Finds out whether texture coordinates wrap somewhere on a face.
 *
 * @param meshes live list of the face's meshes.
 * @param material material with a normal map.
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

/** Whether texture coordinates wrap somewhere on a mesh; see `isTiledBy`. */
export function isTiled({ geometry }: Mesh, material: Material): boolean {
  const map = (material as MeshStandardMaterial).normalMap!
  if (map.matrixAutoUpdate) map.updateMatrix()
  const ranges = rangesOf(geometry.getAttribute(map.channel ? `uv${map.channel}` : 'uv'))
  const [a, d, , b, e, , c, f] = map.matrix.elements
  return isTiledBy(ranges, a, b, c, d, e, f)
}

const knownRanges = new WeakMap<AnyAttribute, UvRanges>()

/** UV ranges of an attribute; cached, because the meshes of a crowd share it. */
function rangesOf(attribute: AnyAttribute): UvRanges {
  const ranges =
    knownRanges.get(attribute) ?? uvRanges(attribute.count, (i, axis) => componentOf(attribute, i, axis))
  knownRanges.set(attribute, ranges)
  return ranges
}
