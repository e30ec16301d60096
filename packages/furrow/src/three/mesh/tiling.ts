import {
  Box2,
  type BufferAttribute,
  type BufferGeometry,
  type InterleavedBufferAttribute,
  type Material,
  Matrix3,
  type Mesh,
  type MeshStandardMaterial,
  type Texture,
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
  const isAnyTiled = () => meshes.some((mesh) => isTiled(mesh, material))
  const wasTiled = isAnyTiled()
  const matrixOf = () => (material as MeshStandardMaterial).normalMap!.matrix
  const known = new Matrix3().copy(matrixOf())
  return {
    isTiled: wasTiled,
    isFor: (mesh) => wasTiled || !isTiled(mesh, material),
    isCurrent() {
      const matrix = matrixOf()
      if (wasTiled || matrix.equals(known)) return true
      known.copy(matrix)
      return !isAnyTiled()
    },
  }
}

/**
 * Whether texture coordinates leave 0..1 somewhere on a mesh, and so wrap: neighbouring pixels may then be at opposite edges of its maps.
 * True of all that a rotated normal map may have so.
 */
export function isTiled({ geometry }: Mesh, material: Material): boolean {
  const { normalMap } = material as MeshStandardMaterial
  const { min, max } = uvBounds(uvAttribute(geometry, normalMap))
  if (normalMap?.matrixAutoUpdate) normalMap.updateMatrix()
  const corners = [min, max, new Vector2(min.x, max.y), new Vector2(max.x, min.y)]
  return corners.some((corner) => {
    const { x, y } = normalMap ? corner.clone().applyMatrix3(normalMap.matrix) : corner
    return Math.min(x, y) < 0 || Math.max(x, y) > 1
  })
}

type AnyAttribute = BufferAttribute | InterleavedBufferAttribute

/** The texture coordinates that a normal map is read at. */
export function uvAttribute(geometry: BufferGeometry, normalMap: Texture | null): AnyAttribute {
  return geometry.getAttribute(normalMap?.channel ? `uv${normalMap.channel}` : 'uv')
}

const boundsOf = new WeakMap<AnyAttribute, Box2>()

/** Found once for all meshes of a crowd. */
function uvBounds(attribute: AnyAttribute): Box2 {
  let bounds = boundsOf.get(attribute)
  if (!bounds) {
    bounds = new Box2()
    const uv = new Vector2()
    for (let i = 0; i < attribute.count; i++) {
      bounds.expandByPoint(uv.fromBufferAttribute(attribute as never, i))
    }
    boundsOf.set(attribute, bounds)
  }
  return bounds
}
