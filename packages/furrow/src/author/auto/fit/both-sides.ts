import type { MorphDriver } from '../../../drivers/morph/definition.ts'
import { mirroredName } from '../../../drivers/morph/mirrored-name.ts'
import { shapeNameOf } from '../../shapes/names/hint.ts'
import type { SkinRegion } from '../anatomy/region.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { type FittedRegion, type MissingRegion, roundWeight } from './fit-driver.ts'

/** The transition between a left and a right area lies within this distance from the middle of the face, in millimetres. */
const MIDDLE = 5

/**
 * Merges the regions of a face whose left and right halves share texels. Only the left regions remain, because their texels show on both sides.
 * The blendshapes of both sides drive the areas of these regions.
 */
export function mergeSides(
  fitted: readonly FittedRegion[],
  prepared: Pick<PreparedSkin, 'names' | 'known' | 'hints' | 'find'>,
): FittedRegion[] {
  return fitted
    .filter(({ region }) => !region.name.endsWith('Right'))
    .map(({ region, driver, ...rest }): FittedRegion => {
      const name = region.name.replace(/Left$/, '')
      const { influence } = region
      const merged: SkinRegion = { ...region, name }
      if (influence) merged.influence = ([across, up]) => influence([Math.max(MIDDLE, across), up])
      const targets = targetsOfBothSides(driver, prepared)
      return { ...rest, driver: { ...driver, area: name, targets }, region: merged }
    })
}

/** Merges the entries of both sides in a list of missing regions. */
export function mergeMissingSides(missing: readonly MissingRegion[]): MissingRegion[] {
  return missing
    .filter(({ name }) => !name.endsWith('Right'))
    .map(({ name, reason }) => ({ name: name.replace(/Left$/, ''), reason }))
}

/** Splits the weight of each blendshape equally between the blendshape and its counterpart on the other side. */
function targetsOfBothSides(
  { targets }: MorphDriver,
  { names, known, hints, find }: Pick<PreparedSkin, 'names' | 'known' | 'hints' | 'find'>,
): MorphDriver['targets'] {
  const weights = new Map<string, number>()
  const add = (name: string, weight: number) => weights.set(name, (weights.get(name) ?? 0) + weight)
  for (const { name, weight = 1 } of targets) {
    const target = names.indexOf(name)
    const shape = shapeNameOf(known[target], hints[target])
    const opposite = mirroredName(shape)
    const [other] = opposite === shape ? [] : find(opposite)
    if (other === undefined) add(name, weight)
    else for (const one of [name, names[other]]) add(one, weight / 2)
  }
  return [...weights].map(([name, weight]) => ({ name, weight: roundWeight(weight) }))
}
