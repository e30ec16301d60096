import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { type RegionSettings, type StrainedRegion, strainFaceRegions } from './face-strain.ts'
import { type CompressedPatch, findPatches } from './patches.ts'

/** Skin that may crease. */
export interface StrainedSkin {
  /** Anatomical regions of a face, each with the strain of its expression. */
  regions: readonly StrainedRegion[]
  /** Patches compressed by targets, on skin that is not a head. */
  patches: readonly CompressedPatch[]
}

export interface StrainSettings extends RegionSettings {
  /** 0 at 20 years, 1 at 80. */
  ageFraction: number
  /** Maximum number of patches. */
  maxAreas: number
}

/**
 * Measures how far targets compress the skin, and in which directions.
 *
 * @param report called with the fraction done.
 */
export function measureStrain(
  prepared: PreparedSkin,
  { ageFraction, maxAreas, ...settings }: StrainSettings,
  report: (fraction: number) => void = () => {},
): StrainedSkin {
  const { face, isUnknownHead } = prepared
  return {
    regions: face ? strainFaceRegions(face, ageFraction, settings, report) : [],
    // Speech compresses cheeks without folding them, so a head without landmarks gets no lines.
    patches: face || isUnknownHead ? [] : findPatches(prepared, maxAreas, report),
  }
}
