import { targetFinder } from '../../drivers/morph/target-names.ts'
import { clamp } from '../../math/scalar.ts'
import { SkinTexels } from '../skin/skin-texels.ts'
import type { Skin } from '../skin/surface.ts'
import { poseStrain } from './strain/pose-strain.ts'
import { principalAt } from './strain/principal.ts'
import { poseOf } from './surface/pose.ts'
import { prepareSkin } from './surface/prepare-skin.ts'

/** Map of the compression of skin. */
export interface StrainMap {
  width: number
  height: number
  /** Fraction of length that the skin loses in the direction of largest loss, 0..1; NaN outside the skin. Row 0 is at v = 0. */
  data: Float32Array
}

/**
 * Computes a map of the compression of skin for each pose. `autoWrinkles` measures the compression in the same way.
 *
 * @param poses weights of blendshapes by name, in the spelling of any rig. Unknown names are ignored.
 * @param size width and height of the maps in texels.
 * @throws FurrowError if `autoWrinkles` could not use the skin.
 */
export function strainMaps(
  skin: Skin,
  poses: readonly Readonly<Record<string, number>>[],
  size: number,
): StrainMap[] {
  const { skin: prepared, names, surface, offsets } = prepareSkin(skin)
  const find = targetFinder(names)
  const texels = new SkinTexels(prepared, surface, size, size)
  return poses.map((pose) => strainMap(texels, poseStrain(surface, offsets, poseOf(find, pose))))
}

function strainMap(texels: SkinTexels, tensors: Float64Array): StrainMap {
  const { width, height, surface } = texels
  const data = new Float32Array(width * height).fill(Number.NaN)
  const barycentrics = new Float64Array(3)
  texels.visit((texel, triangle, a, b, c) => {
    barycentrics.set([a, b, c])
    data[texel] = clamp(principalAt(surface, tensors, triangle, barycentrics).compression, 0, 1)
  })
  return { width, height, data }
}
