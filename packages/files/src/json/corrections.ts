import { type FurrowError, findTargets } from 'furrow'
import { parseCorrections, type ShapeCorrection, WRINKLE_MAPS } from 'furrow/internal'
import { type GltfJson, targetNamesOf } from './gltf-json.ts'
import { namesOfMesh } from './target-names.ts'

/** Reads the corrections of a material's blendshapes, and what is wrong with others: no renderer needs them, so that nothing else suffers. */
export function correctionsIn(
  { materials = [] }: GltfJson,
  material: number,
  who: string,
): { corrections: ShapeCorrection[]; problem?: string } {
  const extension = materials[material]?.extensions?.[WRINKLE_MAPS] as { shapes?: unknown } | null | undefined
  const faults: FurrowError[] = []
  const corrections = parseCorrections(extension?.shapes, who, (fault) => faults.push(fault))
  if (faults.length === 0) return { corrections }
  const others = faults.length > 1 ? ` (${faults.length - 1} more malformed)` : ''
  return { corrections, problem: `${faults[0].message}${others}` }
}

/** Blendshapes that corrections name and no mesh with the material has, e.g. `blendshape "key_12" of mesh "Head"`. */
export function missingIn(
  json: GltfJson,
  material: number,
  corrections: readonly ShapeCorrection[],
): string[] {
  const meshes = (json.meshes ?? []).flatMap((mesh, index) =>
    mesh.primitives.some((primitive) => primitive.material === material)
      ? [{ names: namesOfMesh(json, index), targets: targetNamesOf(mesh) }]
      : [],
  )
  return corrections.flatMap(({ mesh, target }) => {
    const own = meshes.filter(({ names }) => mesh === undefined || names.includes(mesh))
    if (own.some(({ targets }) => findTargets(target, targets).length > 0)) return []
    return [`blendshape "${target}"${mesh === undefined ? '' : ` of mesh "${mesh}"`}`]
  })
}
