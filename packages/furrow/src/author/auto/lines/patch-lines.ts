import { MAX_NAME_LENGTH } from '../../../core/limits.ts'
import { Rng } from '../../../math/rng.ts'
import { MAX_TOTAL_LENGTH } from '../../strokes/lay-out.ts'
import type { LineStyle, SkinRegion } from '../anatomy/region.ts'
import { type CompressedPatch, MIN_PATCH_COMPRESSION, patchTensors } from '../strain/patches.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { type CreasedRegion, creaseLines, type LineSettings } from './crease.ts'
import { layFreeLines } from './free-lines.ts'
import type { StrokedSkin } from './stroke-of.ts'

/** Distance between lines in millimetres. */
const SPACING = 6
/** Maximum total length of lines in millimetres. It is below the limit for strokes, which counts each started segment as a complete one. */
const MAX_LINES_LENGTH = 0.9 * MAX_TOTAL_LENGTH
const STYLE: LineStyle = { width: 2, depth: 1, taper: [0.4, 0.4], shoulder: [0.9, 0.9], softness: 0.5 }

/** Lays lines on compressed patches of skin whose anatomy is not known. The lines are shallower than on a face. */
export function layPatchLines(
  prepared: StrokedSkin & Pick<PreparedSkin, 'names'>,
  patches: readonly CompressedPatch[],
  { ageFraction, strength, seed }: LineSettings,
): CreasedRegion[] {
  const { surface, names } = prepared
  const counts = new Map<string, number>()
  const area = patches.reduce((sum, patch) => sum + patch.area, 0)
  return patches.flatMap((patch): CreasedRegion[] => {
    const target = names[patch.target]
    const name = areaNameOf(target)
    const rng = new Rng(seed, target)
    const tensors = patchTensors(patch, surface.areas.length)
    const laid = layFreeLines(surface, tensors, {
      spacing: SPACING,
      minCompression: MIN_PATCH_COMPRESSION,
      maxTotalLength: (MAX_LINES_LENGTH * patch.area) / area,
      style: STYLE,
    })
    if (laid.length === 0) return []
    const lines = laid.map((line) => ({ ...line, style: variedStyle(rng) }))
    const count = (counts.get(name) ?? 0) + 1
    counts.set(name, count)
    const region: SkinRegion = {
      name: count === 1 ? name : `${name} ${count}`,
      cause: { [target]: 1 },
      spacing: SPACING,
      creasedFraction: 0.25 + 0.35 * ageFraction,
      maxDepth: 0.4 + 0.4 * ageFraction,
      reach: 4,
      feather: 6,
    }
    return [{ region, ...creaseLines(prepared, region, lines, { strength, symmetry: 0 }) }]
  })
}

/** Derives the name of an area from the name of a target. Removes control characters, and leaves room for a number at the end. */
function areaNameOf(target: string): string {
  return (
    target
      .replace(/[\p{Cc}\u2028\u2029]/gu, ' ')
      .trim()
      .slice(0, MAX_NAME_LENGTH - 4) || 'unnamed'
  )
}

/** Returns a random variation of the line style, because lines of equal depth and width look like stripes. */
export function variedStyle(rng: Rng, width = STYLE.width): LineStyle {
  const fade = () => rng.uniform(0.3, 0.5)
  return {
    ...STYLE,
    width: width * rng.uniform(0.85, 1.1),
    depth: rng.uniform(0.7, 1),
    taper: [fade(), fade()],
  }
}
