import { WRINKLE_MAPS } from 'furrow/internal'
import type { Progress } from '../base/progress.ts'
import type { Glb } from '../gltf/glb.ts'
import { missingIn } from '../json/corrections.ts'
import { jointNamesOf, targetNamesOf } from '../json/gltf-json.ts'
import type { Target, TargetNames } from '../json/target-names.ts'
import { findTarget } from '../mesh/target.ts'
import { findDriverProblems } from '../wrinkles/driver-problems.ts'
import { embedWrinkles } from './embed.ts'
import { type PackedSet, type PackOptions, packSet } from './pack.ts'
import type { SetToPack } from './set-to-pack.ts'
import { stripWrinkles } from './strip.ts'

export interface PackedFace {
  target: Target
  wrinkles: PackedSet
  warnings: string[]
}

/**
 * Adds a wrinkle set to a material of a glTF file. Replaces wrinkles that the material already has.
 *
 * @param glb changed in place.
 * @param face path of the file, for errors.
 * @param options mesh and material default to those of the set. If the set names none, `findTarget` chooses.
 * @throws FurrowError if the wrinkles are invalid, or the mesh or the material does not exist.
 */
export async function packFace(
  glb: Glb,
  face: string,
  set: SetToPack,
  options: PackOptions & TargetNames,
  who: string,
  progress: Progress,
): Promise<PackedFace> {
  const target = await findTarget(glb, face, who, {
    mesh: options.mesh ?? set.mesh,
    material: options.material ?? set.material,
  })
  const wrinkles = await packSet(set, options, who, progress)
  const isWrinkled = glb.json.materials![target.material].extensions?.[WRINKLE_MAPS] !== undefined
  if (isWrinkled) stripWrinkles(glb, target.material, who)
  embedWrinkles(glb, target.material, wrinkles, who)
  const targets = targetNamesOf(glb.json.meshes![target.mesh])
  const { missing } = findDriverProblems(wrinkles.drivers, targets, jointNamesOf(glb.json))
  const { shapes = [] } = wrinkles
  const unknown = [...missing, ...missingIn(glb.json, target.material, shapes)].map(
    (name) => `${who}: ${name} does not exist; the reference to it is kept`,
  )
  return { target, wrinkles, warnings: [...wrinkles.warnings, ...unknown] }
}
