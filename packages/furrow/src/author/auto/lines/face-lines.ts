import type { StrainedRegion } from '../strain/face-strain.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import { type CreasedRegion, creaseLines, type LineSettings, type RegionCreases } from './crease.ts'
import { layFilm } from './film-lines.ts'
import { layGuides } from './guided-lines.ts'
import type { StrokedSkin } from './stroke-of.ts'

/**
 * Lays the lines of anatomical regions on a face. Lines that start where the mesh has no skin are left out.
 * Regions with the same `guides` or `film` object share creases.
 *
 * @param report called with the fraction done, 0..1.
 */
export function layFaceLines(
  prepared: StrokedSkin,
  face: Pick<DetectedFace, 'surface' | 'chart'>,
  regions: readonly StrainedRegion[],
  settings: Pick<LineSettings, 'strength' | 'symmetry'>,
  report: (fraction: number) => void,
): CreasedRegion[] {
  const known = new Map<unknown, RegionCreases>()
  return regions.map(({ region, tensors }, i): CreasedRegion => {
    const ofRegion = (fraction: number) => report((i + fraction) / regions.length)
    const source = 'film' in region ? region.film : region.guides
    const lay = () =>
      'film' in region
        ? layFilm(face, region, tensors, ofRegion)
        : layGuides(face.surface, face.chart, region.guides, tensors)
    const creased = known.get(source) ?? creaseLines(prepared, region, lay(), settings)
    known.set(source, creased)
    return { region, ...creased }
  })
}
