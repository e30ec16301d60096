import type { FaceRegion } from '../anatomy/region.ts'
import type { StrainedRegion } from '../strain/face-strain.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import { type CreasedRegion, creaseLines, type LineSettings, type RegionCreases } from './crease.ts'
import { layFilm } from './film-lines.ts'
import { layGuides } from './guided-lines.ts'
import { applyStrengths } from './region-strengths.ts'
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
  settings: Pick<LineSettings, 'strength' | 'strengths' | 'symmetry'>,
  report: (fraction: number) => void,
): CreasedRegion[] {
  const known = new Map<unknown, RegionCreases>()
  return regions.map(({ region, tensors }, i): CreasedRegion => {
    const ofRegion = (fraction: number) => report((i + fraction) / regions.length)
    const source = sourceOf(region)
    const crease = () => {
      const laid =
        'film' in region
          ? layFilm(face, region, tensors, ofRegion)
          : layGuides(face.surface, face.chart, region.guides, tensors)
      const sharing = regions.flatMap(({ region: other }) => (sourceOf(other) === source ? other : []))
      const { lines, factor } = applyStrengths(laid, sharing, settings.strengths)
      return creaseLines(prepared, region, lines, { ...settings, strength: settings.strength * factor })
    }
    const creased = known.get(source) ?? crease()
    known.set(source, creased)
    return { region, ...creased }
  })
}

/** Returns the object from which a region's lines are made. */
function sourceOf(region: FaceRegion): unknown {
  return 'film' in region ? region.film : region.guides
}
