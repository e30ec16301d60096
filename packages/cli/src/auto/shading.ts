import type { GltfJson } from '../gltf/gltf-json.ts'
import { missingAttributes } from '../wrinkles/face-rules.ts'

const UNLIT = 'KHR_materials_unlit'
const MTOON = 'VRMC_materials_mtoon'

/** How a material is drawn: toon materials have their own shader; `unlit` ones have no normals, and so no wrinkles. */
export function shadingOf(
  { materials = [], extensions }: GltfJson,
  material: number,
): 'lit' | 'unlit' | 'toon' {
  const own = materials[material]?.extensions ?? {}
  if (own[MTOON] !== undefined || isToonOfVrm0(extensions?.VRM, material)) return 'toon'
  return own[UNLIT] === undefined ? 'lit' : 'unlit'
}

/** VRM 0 lists its shaders beside the materials, whose fallback is unlit. */
function isToonOfVrm0(vrm: unknown, material: number): boolean {
  const { materialProperties } = (vrm ?? {}) as { materialProperties?: { shader?: unknown }[] }
  const shader = Array.isArray(materialProperties) ? materialProperties[material]?.shader : undefined
  return typeof shader === 'string' && shader.includes('MToon')
}

/** What the user should know about a material, and the meshes that have it, before wrinkles are made for it. */
export function skinWarnings(json: GltfJson, material: number, name: string): string[] {
  const missing = missingAttributes(json, material).map(({ message }) => {
    return `the material "${name}" shows no wrinkles: ${message}`
  })
  const shading = shadingWarning(shadingOf(json, material), name)
  return shading ? [...missing, shading] : missing
}

function shadingWarning(shading: ReturnType<typeof shadingOf>, name: string): string | undefined {
  if (shading === 'unlit')
    return `the material "${name}" is unlit (${UNLIT}): it shows no wrinkles until it is a lit one`
  if (shading === 'toon') return `the material "${name}" is MToon: wrinkles are composed into its normal map`
  return undefined
}
