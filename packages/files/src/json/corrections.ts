import { type FurrowError, findTargets } from 'furrow'
import { parseCorrections, type ShapeCorrection, WRINKLE_MAPS } from 'furrow/internal'
import { type GltfJson, targetNamesOf } from './gltf-json.ts'
import { namesOfMesh } from './target-names.ts'

/**
 * Reads from a material's extension the user's corrections of automatically recognised blendshapes. Skips malformed
 * corrections and describes them in `problem`, because renderers do not need corrections.
 */
export function correctionsIn(
  { materials = [] }: GltfJson,
  material: number,
  who: string,
): { corrections: ShapeCorrection[]; problem?: string } {
  const extension = materials[material]?.extensions?.[WRINKLE_MAPS] as { shapes?: unknown } | null | undefined
  const errors: FurrowError[] = []
  const corrections = parseCorrections(extension?.shapes, who, (error) => errors.push(error))
  if (errors.length === 0) return { corrections }
  const others = errors.length > 1 ? ` (${errors.length - 1} more malformed)` : ''
  return { corrections, problem: `${errors[0].message}${others}` }
}

/** Lists the corrected blendshapes that no mesh with the material has, e.g. `blendshape "key_12" of mesh "Head"`. */
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
