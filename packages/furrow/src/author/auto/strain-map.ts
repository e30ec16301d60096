import { targetFinder } from '../../drivers/morph/target-names.ts'
import { poseOf } from './face.ts'
import { prepareSkin } from './prepare.ts'
import { principalAt } from './principal.ts'
import { strainOf } from './strain.ts'
import type { Skin, Surface } from './surface.ts'
import { SkinTexels } from './texels.ts'

/** How far skin is pushed together, in its texture. */
export interface StrainMap {
  width: number
  height: number
  /** Row 0 at the top: the largest share of its length that skin loses in any direction, 0..1; NaN where there is no skin. */
  data: Float32Array
}

/**
 * Maps what poses do to a skin: the principal compression at each texel, as `autoWrinkles` sees it.
 *
 * @param poses weights by target, in any rig's spelling; what the skin does not have is passed over.
 * @param size side of the maps in texels.
 * @throws FurrowError as `autoWrinkles` does.
 */
export function strainMaps(
  skin: Skin,
  poses: readonly Readonly<Record<string, number>>[],
  size: number,
): StrainMap[] {
  const { skin: usable, surface, offsets } = prepareSkin(skin)
  const find = targetFinder(usable.targets.map(({ name }) => name))
  const texels = new SkinTexels(usable, surface, size)
  return poses.map((pose) => strainMap(surface, strainOf(surface, offsets, poseOf(find, pose)), texels))
}

/** The principal compression of one field of tensors at each texel. */
function strainMap(surface: Surface, tensors: Float64Array, texels: SkinTexels): StrainMap {
  const { size } = texels
  const data = new Float32Array(size * size).fill(Number.NaN)
  texels.visit(
    () => true,
    (texel, triangle, a, b, c) => {
      const { lost } = principalAt(surface, tensors, triangle, [a, b, c])
      data[texel] = Math.min(1, Math.max(0, lost))
    },
  )
  return { width: size, height: size, data }
}
