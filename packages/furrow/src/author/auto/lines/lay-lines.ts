import type { StrainedSkin } from '../strain/measure-strain.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import type { CreasedRegion, LineSettings } from './crease.ts'
import { layFaceLines } from './face-lines.ts'
import { layPatchLines } from './patch-lines.ts'

/**
 * Lays lines where the skin can crease, and computes their depths. On a face, the lines follow its anatomy.
 *
 * @param report called with the fraction done, 0..1.
 */
export function layLines(
  prepared: PreparedSkin,
  { regions, patches }: StrainedSkin,
  settings: LineSettings,
  report: (fraction: number) => void = () => {},
): CreasedRegion[] {
  return prepared.face
    ? layFaceLines(prepared, prepared.face, regions, settings, report)
    : layPatchLines(prepared, patches, settings)
}
