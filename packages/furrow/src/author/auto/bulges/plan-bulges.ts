import type { MissingRegion } from '../fit/fit-driver.ts'
import { regionStrength, type Strengths } from '../lines/region-strengths.ts'
import { faceContext, type RegionSettings } from '../strain/face-strain.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import type { BulgeRegion } from './bulge-region.ts'
import { type BulgingSkin, type LaidBulge, layBulges } from './lay-bulges.ts'
import { bulgeRegions } from './regions.ts'

/** Minimum number of layers for lines beside the layer of bulges, because lines that cross need two. */
const LINE_LAYERS = 2

/** Bulges of a face, before they are drawn. */
export interface PlannedBulges {
  bulges: readonly LaidBulge[]
  /** Requested regions that do not bulge. */
  missing: readonly MissingRegion[]
}

export interface BulgeSettings extends RegionSettings {
  /** Age as a number from 0 (20 years) to 1 (80 years). */
  ageFraction: number
  /** Factor on the heights. */
  strength: number
  /** Factors on the heights in single regions. */
  strengths: Strengths
  /** Number of layers for lines and bulges. */
  layers: number
}

/** Chooses and lays the bulges of a face. */
export function planBulges(
  skin: BulgingSkin & { face: DetectedFace; isMirrored: boolean },
  { ageFraction, strength, strengths, layers, ...settings }: BulgeSettings,
): PlannedBulges {
  const both = bulgeRegions(faceContext(skin.face, ageFraction, settings), settings.regions).map((region) =>
    scaled(region, regionStrength(strengths, region.name)),
  )
  const regions = skin.isMirrored ? leftAlone(both) : both
  if (layers <= LINE_LAYERS) {
    const reason = `it needs a separate layer, beside ${LINE_LAYERS} with lines`
    return { bulges: [], missing: regions.map(({ name }) => ({ name, reason })) }
  }
  const { laid, missing } = layBulges(skin, regions, strength)
  return { bulges: laid, missing }
}

/** Multiplies the heights of a region by a factor. */
function scaled({ name, lines }: BulgeRegion, factor: number): BulgeRegion {
  return { name, lines: lines.map((line) => ({ ...line, height: factor * line.height })) }
}

/** Keeps the left regions of a face whose halves share texels. They show on both sides. */
function leftAlone(regions: readonly BulgeRegion[]): BulgeRegion[] {
  return regions
    .filter(({ name }) => name.endsWith('Left'))
    .map((region) => ({ ...region, name: region.name.replace(/Left$/, '') }))
}
