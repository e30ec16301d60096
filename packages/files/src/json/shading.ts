import type { GltfJson } from './gltf-json.ts'

const UNLIT = 'KHR_materials_unlit'
const MTOON = 'VRMC_materials_mtoon'

/** Returns how a material is shaded. `unlit` materials use no normals, so they cannot show wrinkles. */
export function shadingOf(
  { materials = [], extensions }: GltfJson,
  material: number,
): 'lit' | 'unlit' | 'toon' {
  const own = materials[material]?.extensions ?? {}
  if (own[MTOON] !== undefined || isToonOfVrm0(extensions?.VRM, material)) return 'toon'
  return own[UNLIT] === undefined ? 'lit' : 'unlit'
}

/**
 * Returns whether VRM 0 data assigns the MToon shader to a material. Its glTF material is then only an unlit fallback.
 */
function isToonOfVrm0(vrm: unknown, material: number): boolean {
  const { materialProperties } = (vrm ?? {}) as { materialProperties?: { shader?: unknown }[] }
  const shader = Array.isArray(materialProperties) ? materialProperties[material]?.shader : undefined
  return typeof shader === 'string' && shader.includes('MToon')
}
