import { FurrowError } from 'furrow'
import type { GltfJson, GltfMesh } from '../json/gltf-json.ts'
import { shadingOf } from '../json/shading.ts'
import type { Target } from '../json/target-names.ts'
import { errorFinding, type Finding, warningFinding } from './finding.ts'

type Primitive = GltfMesh['primitives'][number]

/** First primitive mode with triangles. Lower modes are points and lines. */
const TRIANGLES = 4

/** Attributes that a mesh needs to show wrinkles, each with a remedy. */
const ATTRIBUTES = [
  ['POSITION', 'export the file again'],
  ['NORMAL', 'export the mesh with normals'],
  ['TEXCOORD_0', 'unwrap the mesh: areas and layers are in its UV layout'],
] as const

const SHADING_FINDINGS = {
  lit: undefined,
  unlit: errorFinding('UNLIT', 'it is unlit (KHR_materials_unlit); make it a lit material'),
  toon: warningFinding('MTOON', 'it is MToon: pages that register three-vrm draw wrinkles as lines'),
} as const

/** Returns whether a scene has triangles with this material. */
export function isDrawn(json: GltfJson, material: number): boolean {
  return drawnPrimitives(json, material).length > 0
}

/**
 * Checks whether a material is lit, and whether its meshes have the attributes that loaders need to show wrinkles.
 *
 * @param faces indices of the meshes to check. Other meshes with the material are ignored.
 */
export function checkFaces(json: GltfJson, material: number, faces: readonly number[]): Finding[] {
  const shading = SHADING_FINDINGS[shadingOf(json, material)]
  return [...missingAttributes(json, material, faces), ...(shading ? [shading] : [])]
}

/**
 * Checks a mesh and a material before wrinkles are added.
 *
 * @returns warnings.
 * @throws FurrowError if loaders would not show wrinkles on this mesh.
 */
export function faceWarnings(
  json: GltfJson,
  { mesh, material }: Target,
  name: string,
  who: string,
): string[] {
  const findings = checkFaces(json, material, [mesh])
  const error = findings.find(({ severity }) => severity === 'error')
  if (error) {
    const [reason, remedy] = error.message.split('; ')
    throw new FurrowError({ who, problem: `the material "${name}" cannot show wrinkles: ${reason}`, remedy })
  }
  return findings.map(({ message }) => `the material "${name}": ${message}`)
}

/** Lists the required attributes that meshes with a material lack. */
function missingAttributes(json: GltfJson, material: number, faces: readonly number[]): Finding[] {
  const primitives = drawnPrimitives(json, material, faces)
  return ATTRIBUTES.flatMap(([name, remedy]) => {
    if (primitives.every(({ attributes = {} }) => attributes[name] !== undefined)) return []
    return [errorFinding('ATTRIBUTE', `a mesh with this material has no ${name}; ${remedy}`)]
  })
}

function drawnPrimitives(json: GltfJson, material: number, faces?: readonly number[]): Primitive[] {
  return meshesInScenes(json).flatMap((index) => {
    if (faces && !faces.includes(index)) return []
    const primitives = json.meshes?.[index]?.primitives ?? []
    return primitives.filter((primitive) => {
      return primitive.material === material && (primitive.mode ?? TRIANGLES) >= TRIANGLES
    })
  })
}

/** Returns the indices of the meshes that at least one scene of the file contains. */
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
