import { FurrowError } from 'furrow'
import { didYouMean } from 'furrow/internal'
import { documentOf } from '../gltf/document.ts'
import type { Glb } from '../gltf/glb.ts'
import {
  type Candidate,
  chosen,
  materialsOf,
  meshesOf,
  type Target,
  type TargetNames,
} from '../json/target-names.ts'
import { mostMovedSkin } from './find-skin.ts'

/**
 * Finds the mesh and the material that get wrinkles. Without names, chooses those named `skin`. If there are none,
 * chooses the only mesh and material. If there are several, chooses those with more than half of the blendshape motion.
 *
 * @param path path of the file, for errors.
 * @param names names of mesh and material. The name of the mesh's node also selects the mesh.
 * @throws FurrowError if none matches, or several match and none has more than half of the motion.
 */
export async function findTarget(glb: Glb, path: string, who: string, names: TargetNames): Promise<Target> {
  const { json } = glb
  const meshes = chosen(meshesOf(json), names.mesh)
  if (meshes.length === 0) throw notFound(meshesOf(json), names.mesh, who, 'mesh', '--mesh')
  const materials = meshes.flatMap(({ index }) => materialsOf(json, index))
  // If several meshes are left, a material named `skin` must not decide which mesh gets wrinkles.
  const left =
    meshes.length > 1 && names.material === undefined ? materials : chosen(materials, names.material)
  if (left.length === 0) {
    throw notFound(materials, names.material, who, 'material of that mesh', '--material')
  }
  if (left.length === 1) return left[0].target
  const meshName = meshes.length === 1 ? json.meshes?.[meshes[0].index].name : undefined
  const skin = mostMovedSkin(await documentOf(glb, path, who), meshName)
  const moved = left.find(({ target }) => target.mesh === skin?.mesh && target.material === skin.material)
  if (moved) return moved.target
  throw meshes.length > 1
    ? notFound(meshes, undefined, who, 'mesh', '--mesh')
    : notFound(left, undefined, who, 'material of that mesh', '--material')
}

function notFound(
  candidates: readonly Candidate[],
  wanted: string | undefined,
  who: string,
  kind: string,
  option: string,
): FurrowError {
  const all = candidates.map(({ names, index }) => names[0] ?? String(index))
  return new FurrowError({
    code: 'unknown-name',
    who,
    problem:
      wanted !== undefined || all.length === 0 ? `no such ${kind}` : `several candidates for the ${kind}`,
    value: wanted,
    limit: all.length === 0 ? 'the file has none with texture coordinates' : all.join(', '),
    remedy: didYouMean(wanted, all, `name one with ${option}`),
  })
}
