import type { GltfJson, TextureInfo } from '../json/gltf-json.ts'

const TRANSFORM = 'KHR_texture_transform'
const FLOAT = 5126

/** PNG of one texel with a flat normal: (128, 128, 255). */
export const FLAT_NORMAL = Uint8Array.from(
  atob(
    'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAACXBIWXMAAAPoAAAD6AG1e1JrAAAADElEQVQI12NoaPgPAAODAgDRhuTWAAAAAElFTkSuQmCC',
  ),
  (letter) => letter.charCodeAt(0),
)

/**
 * Returns the texture info of the base colour if its transform decodes quantised texture coordinates
 * (KHR_mesh_quantization) and the material has no normal map. Wrinkles use the coordinates of the normal map, so the
 * material then needs a normal map with this transform.
 */
export function quantisedCoordinates(json: GltfJson, material: number): TextureInfo | undefined {
  const { normalTexture, pbrMetallicRoughness } = json.materials?.[material] ?? {}
  const base = pbrMetallicRoughness?.baseColorTexture
  if (normalTexture || base?.extensions?.[TRANSFORM] === undefined) return undefined
  const { texCoord = base.texCoord ?? 0 } = base.extensions[TRANSFORM] as { texCoord?: number }
  const primitives = (json.meshes ?? []).flatMap((mesh) => mesh.primitives)
  const used = primitives
    .filter((primitive) => primitive.material === material)
    .map(({ attributes }) => json.accessors?.[attributes?.[`TEXCOORD_${texCoord}`] ?? -1])
  const areQuantised = used.every(
    (accessor) => accessor && (accessor as { componentType?: number }).componentType !== FLOAT,
  )
  return used.length > 0 && areQuantised ? base : undefined
}
