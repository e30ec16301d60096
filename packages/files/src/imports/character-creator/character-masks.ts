import { FurrowError, type GrayImage } from 'furrow'
import { clamp, resampleGray } from 'furrow/internal'
import { channelOf, type Pixels } from '../../images/pixels.ts'
import { type SourceFiles, stemOf } from '../source-files.ts'
import { readSourceImage } from '../source-image.ts'
import { MASKS, type MaskName, type Rule, type Side } from './rules.ts'

/** Left and right masks fade into each other around the middle of the texture, where u is between these values. */
const MIDDLE = [0.49, 0.51] as const

/**
 * Reads the masks, which the add-ons for Blender and Unity ship beside their textures.
 *
 * @throws FurrowError if a mask is missing or damaged.
 */
export async function readMasks(files: SourceFiles, who: string): Promise<ReadonlyMap<MaskName, Pixels>> {
  const masks = new Map<MaskName, Pixels>()
  for (const name of MASKS) {
    const path = files.paths.find((one) => stemOf(one) === `rl_wrinklemask_${name}`.toLowerCase())
    if (path === undefined) throw missingMask(files, name, who)
    masks.set(name, await readSourceImage(files, path, who))
  }
  return masks
}

/** Returns the weights of a rule on one side, or on both sides if it has none. */
export function ruleWeights(
  masks: ReadonlyMap<MaskName, Pixels>,
  { mask, channel, isSided }: Rule,
  side: Side,
  size: number,
): GrayImage {
  const weights = resampleGray(channelOf(masks.get(mask)!, channel), size)
  if (!isSided) return weights
  const data = weights.data.map((weight, i) => Math.round(weight * sideAt(((i % size) + 0.5) / size, side)))
  return { ...weights, data }
}

function sideAt(u: number, side: Side): number {
  const left = clamp((u - MIDDLE[0]) / (MIDDLE[1] - MIDDLE[0]), 0, 1)
  return side === 'L' ? left : 1 - left
}

function missingMask({ name }: SourceFiles, mask: MaskName, who: string): FurrowError {
  const files = MASKS.map((one) => `RL_WrinkleMask_${one}.png`).join(', ')
  return new FurrowError({
    code: 'unreadable',
    who,
    problem: `the mask RL_WrinkleMask_${mask} is missing in ${name}`,
    limit: files,
    remedy: 'copy the masks from the folder textures of CC/iC Blender Tools into the export',
  })
}
