import {
  type BufferAttribute,
  type InterleavedBufferAttribute,
  type Material,
  type Mesh,
  type MeshStandardMaterial,
  Vector2,
} from 'three'

/** Whether texture coordinates wrap somewhere on a face, as its shader was made for. */
export interface Tiling {
  readonly isTiled: boolean
  /** Whether the shader is right for another mesh of the face. */
  isFor(mesh: Mesh): boolean
  /** Whether it still is when the page has changed the transform of the normal map. */
  isCurrent(): boolean
}

/**
 * @param meshes of the face: a list that may grow.
 * @param material with a normal map.
 */
export function tilingOf(meshes: readonly Mesh[], material: Material): Tiling {
  const matrixOf = () => (material as MeshStandardMaterial).normalMap!.matrix
  const isFor = (mesh: Mesh) => wasTiled || !isTiled(mesh, material)
  let wasTiled = false
  wasTiled = !meshes.every(isFor)
  const known = matrixOf().clone()
  return {
    isTiled: wasTiled,
    isFor,
    isCurrent() {
      if (matrixOf().equals(known)) return true
      known.copy(matrixOf())
      return meshes.every(isFor)
    },
  }
}

/**
 * Whether texture coordinates leave 0..1 somewhere on a mesh, and so wrap: neighbouring pixels may then be at opposite edges of its maps.
 * True of all that a rotated normal map may have so.
 */
export function isTiled({ geometry }: Mesh, material: Material): boolean {
  const map = (material as MeshStandardMaterial).normalMap!
  if (map.matrixAutoUpdate) map.updateMatrix()
  const [us, vs] = uvRanges(geometry.getAttribute(map.channel ? `uv${map.channel}` : 'uv'))
  return us.some((u) =>
    vs.some((v) => {
      const { x, y } = new Vector2(u, v).applyMatrix3(map.matrix)
      return Math.min(x, y) < 0 || Math.max(x, y) > 1
    }),
  )
}

type AnyAttribute = BufferAttribute | InterleavedBufferAttribute
type Range = [least: number, largest: number]

const knownRanges = new WeakMap<AnyAttribute, [Range, Range]>()

/** Of u and v; found once for all meshes of a crowd. */
function uvRanges(attribute: AnyAttribute): [Range, Range] {
  const ranges = knownRanges.get(attribute) ?? [rangeOf(attribute, 0), rangeOf(attribute, 1)]
  knownRanges.set(attribute, ranges)
  return ranges
}

function rangeOf(attribute: AnyAttribute, axis: number): Range {
  const range: Range = [Infinity, -Infinity]
  for (let i = 0; i < attribute.count; i++) {
    const coordinate = attribute.getComponent(i, axis)
    range[0] = Math.min(range[0], coordinate)
    range[1] = Math.max(range[1], coordinate)
  }
  return range
}
