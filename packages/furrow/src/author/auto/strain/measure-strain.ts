import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { type RegionSettings, type StrainedRegion, strainFaceRegions } from './face-strain.ts'
import { type CompressedPatch, findPatches } from './patches.ts'

/** Parts of the skin that can crease, and how they are compressed. */
export interface StrainedSkin {
  /** Anatomical regions of a face; empty for other skin. */
  regions: readonly StrainedRegion[]
  /** Patches that blendshapes compress; empty for heads. */
  patches: readonly CompressedPatch[]
}

export interface StrainSettings extends RegionSettings {
  /** Age as a number from 0 (20 years) to 1 (80 years). */
  ageFraction: number
  maxAreas: number
}

/**
 * Measures how far blendshapes compress the skin, and in which directions.
 *
 * @param report called with the finished fraction of the work.
 */
export function measureStrain(
  prepared: PreparedSkin,
  { ageFraction, maxAreas, ...settings }: StrainSettings,
  report: (fraction: number) => void = () => {},
): StrainedSkin {
  const { face, isUnknownHead } = prepared
  return {
    regions: face ? strainFaceRegions(face, ageFraction, settings, report) : [],
    // On heads, compression alone does not show where lines are: speech, for example, compresses cheeks without folding them.
    patches: face || isUnknownHead ? [] : findPatches(prepared, maxAreas, report),
  }
}
