import type { GltfJson, GltfMesh } from '../json/gltf-json.ts'
import { shadingOf } from '../json/shading.ts'
import { errorFinding, type Finding, warningFinding } from './finding.ts'

type Primitive = GltfMesh['primitives'][number]

/** The first mode of triangles; points and lines come before it. */
const TRIANGLES = 4

/** What a mesh needs to wrinkle, and what to do where it has none. */
const ATTRIBUTES = [
  ['POSITION', 'export the file again'],
  ['NORMAL', 'export the mesh with normals'],
  ['TEXCOORD_0', 'unwrap the mesh: areas and layers are in its UV layout'],
] as const

/** What the shading of a material means for its wrinkles. */
const SHADING_FINDINGS = {
  lit: undefined,
  unlit: errorFinding('UNLIT', 'it is unlit (KHR_materials_unlit); make it a lit one'),
  toon: warningFinding('MTOON', 'it is MToon: wrinkles are drawn as lines, by pages that register three-vrm'),
} as const

/** Whether a scene has triangles with a material. */
export function isDrawn(json: GltfJson, material: number): boolean {
  return drawnPrimitives(json, material).length > 0
}

/** Checks that everything drawn with a material can wrinkle, as loaders do. */
export function checkFaces(json: GltfJson, material: number): Finding[] {
  const shading = SHADING_FINDINGS[shadingOf(json, material)]
  return [...missingAttributes(json, material), ...(shading ? [shading] : [])]
}

/** The same, in words for a user whose material gets wrinkles. */
export function faceWarnings(json: GltfJson, material: number, name: string): string[] {
  return checkFaces(json, material).map(({ severity, message }) => {
    return `the material "${name}"${severity === 'error' ? ' shows no wrinkles' : ''}: ${message}`
  })
}

/** What meshes with a material lack to wrinkle. */
function missingAttributes(json: GltfJson, material: number): Finding[] {
  const primitives = drawnPrimitives(json, material)
  return ATTRIBUTES.flatMap(([name, remedy]) => {
    if (primitives.every(({ attributes = {} }) => attributes[name] !== undefined)) return []
    return [errorFinding('ATTRIBUTE', `a mesh with this material has no ${name}; ${remedy}`)]
  })
}

function drawnPrimitives(json: GltfJson, material: number): Primitive[] {
  return meshesInScenes(json).flatMap((index) => {
    const primitives = json.meshes?.[index]?.primitives ?? []
    return primitives.filter((primitive) => {
      return primitive.material === material && (primitive.mode ?? TRIANGLES) >= TRIANGLES
    })
  })
}

/** Indices of the meshes that some scene has. */
function meshesInScenes({ scenes = [], nodes = [] }: GltfJson): number[] {
  const reached = new Set<number>()
  let level = scenes.flatMap((scene) => scene.nodes ?? [])
  while (level.length > 0) {
    const fresh = [...new Set(level)].filter((index) => !reached.has(index))
    for (const index of fresh) reached.add(index)
    level = fresh.flatMap((index) => nodes[index]?.children ?? [])
  }
  return [...new Set([...reached].flatMap((index) => nodes[index]?.mesh ?? []))]
}
