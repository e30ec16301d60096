import type { StrainedRegion } from '../strain/face-strain.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import { type CreasedRegion, creaseLines, type LineSettings, type RegionCreases } from './crease.ts'
import { layGuides } from './guided-lines.ts'
import type { StrokedSkin } from './stroke-of.ts'

/** Lays the lines of anatomical regions on a face. Lines that start where the mesh has no skin are left out. */
export function layFaceLines(
  prepared: StrokedSkin,
  { surface, chart }: DetectedFace,
  regions: readonly StrainedRegion[],
  { strength }: Pick<LineSettings, 'strength'>,
): CreasedRegion[] {
  const known = new Map<unknown, RegionCreases>()
  return regions.map(({ region, tensors }): CreasedRegion => {
    const creased =
      known.get(region.guides) ??
      creaseLines(prepared, region, layGuides(surface, chart, region.guides, tensors), strength)
    known.set(region.guides, creased)
    return { region, ...creased }
  })
}
