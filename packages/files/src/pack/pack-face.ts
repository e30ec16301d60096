import { WRINKLE_MAPS } from 'furrow/internal'
import type { Progress } from '../base/progress.ts'
import type { Glb } from '../gltf/glb.ts'
import { missingIn } from '../json/corrections.ts'
import { jointNamesOf, targetNamesOf } from '../json/gltf-json.ts'
import type { Target, TargetNames } from '../json/target-names.ts'
import { findTarget } from '../mesh/target.ts'
import { findDriverFaults } from '../wrinkles/driver-faults.ts'
import { embedWrinkles } from './embed.ts'
import { type PackedSet, type PackOptions, packSet } from './pack.ts'
import type { SetToPack } from './set-to-pack.ts'
import { stripWrinkles } from './strip.ts'

/** A face that got wrinkles. */
export interface PackedFace {
  target: Target
  wrinkles: PackedSet
  /** For the user. */
  warnings: string[]
}

/**
 * Adds a wrinkle set to a face, in place of the one that the material has.
 *
 * @param glb changed in place.
 * @param face path of the face, for errors.
 * @param options the mesh and the material by default those of the set, or as `findTarget` finds them.
 * @throws FurrowError when the wrinkles cannot be used, or there is no such mesh or material.
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
  const { missing } = findDriverFaults(wrinkles.drivers, targets, jointNamesOf(glb.json))
  const { shapes = [] } = wrinkles
  const unknown = [...missing, ...missingIn(glb.json, target.material, shapes)].map(
    (what) => `${who}: ${what} does not exist; it is kept`,
  )
  return { target, wrinkles, warnings: [...wrinkles.warnings, ...unknown] }
}
