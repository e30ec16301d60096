import { targetFinder } from '../../drivers/morph/target-names.ts'
import { clamp } from '../../math/scalar.ts'
import { SkinTexels } from '../skin/skin-texels.ts'
import type { Skin } from '../skin/surface.ts'
import { poseStrain } from './strain/pose-strain.ts'
import { principalAt } from './strain/principal.ts'
import { poseOf } from './surface/pose.ts'
import { prepareSkin } from './surface/prepare-skin.ts'

/** How far skin is compressed, in its texture. */
export interface StrainMap {
  width: number
  height: number
  /** Row 0 at the top: the largest fraction of its length that skin loses in any direction, 0..1; NaN where there is no skin. */
  data: Float32Array
}

/**
 * Maps the principal compression of poses at each texel, as `autoWrinkles` measures it.
 *
 * @param poses weights by target, in any rig's spelling; targets that the skin lacks are ignored.
 * @param size side of the maps in texels.
 * @throws FurrowError as `autoWrinkles` does.
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
