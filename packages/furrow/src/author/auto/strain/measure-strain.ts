import type { AutoRegion } from '../anatomy/regions.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { type StrainedRegion, strainFaceRegions } from './face-strain.ts'
import { type CompressedPatch, findPatches } from './patches.ts'

/** Where skin may crease. */
export interface StrainedSkin {
  /** Of a face: its anatomical regions, each with the strain of its expression. */
  regions: readonly StrainedRegion[]
  /** Of any other skin: the patches that its targets compress. */
  patches: readonly CompressedPatch[]
}

export interface StrainSettings {
  /** 0 at 20 years, 1 at 80. */
  ageFraction: number
  seed: number
  regions: readonly AutoRegion[]
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
  { ageFraction, seed, regions, maxAreas }: StrainSettings,
  report: (fraction: number) => void = () => {},
): StrainedSkin {
  return prepared.face
    ? { regions: strainFaceRegions(prepared.face, ageFraction, seed, regions, report), patches: [] }
    : { regions: [], patches: findPatches(prepared, maxAreas, report) }
}
