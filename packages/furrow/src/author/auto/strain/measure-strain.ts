import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { type RegionSettings, type StrainedRegion, strainFaceRegions } from './face-strain.ts'
import { type CompressedPatch, findPatches } from './patches.ts'

/** Where skin may crease. */
export interface StrainedSkin {
  /** Of a face: its anatomical regions, each with the strain of its expression. */
  regions: readonly StrainedRegion[]
  /** Patches that the targets compress, of skin that is no head. */
  patches: readonly CompressedPatch[]
}

export interface StrainSettings extends RegionSettings {
  /** 0 at 20 years, 1 at 80. */
  ageFraction: number
  /** Patches at most. */
  maxAreas: number
}

/**
 * Measures how far targets compress the skin, and in which directions.
 *
 * @param report is given the fraction that is done.
 */
export function measureStrain(
  prepared: PreparedSkin,
  { ageFraction, maxAreas, ...settings }: StrainSettings,
  report: (fraction: number) => void = () => {},
): StrainedSkin {
  const { face, isUnknownHead } = prepared
  return {
    regions: face ? strainFaceRegions(face, ageFraction, settings, report) : [],
    // Speech compresses cheeks too, and these do not fold: without anatomy a head gets no lines.
    patches: face || isUnknownHead ? [] : findPatches(prepared, maxAreas, report),
  }
}
