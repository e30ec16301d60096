import type { CreasedRegion } from '../lines/crease.ts'
import { poseOf } from '../surface/pose.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { standInsOf } from '../surface/stand-ins.ts'
import { mergeMissingSides, mergeSides } from './both-sides.ts'
import { type FittedRegion, fitDriver, type MissingRegion } from './fit-driver.ts'

export interface FittedSkin {
  regions: readonly FittedRegion[]
  missing: readonly MissingRegion[]
  /** Each warning is a complete sentence without a full stop. */
  warnings: readonly string[]
}

/**
 * Fits a driver to each region of skin with wrinkle lines. A driver computes an activation from blendshape weights.
 *
 * @param maxAreas maximum number of areas. Regions with the least compression are dropped.
 * @param report called with the finished fraction of the work.
 */
export function fitDrivers(
  prepared: PreparedSkin,
  creased: readonly CreasedRegion[],
  maxAreas: number,
  report: (fraction: number) => void,
): FittedSkin {
  const { face, known, hints, find, isMirrored } = prepared
  const fitted: FittedRegion[] = []
  const missing: MissingRegion[] = []
  /** For each region that has lines but no driver, its cause as a text, so that causes can be compared. */
  const failed = new Map<string, string>()
  const causeOf = ({ region }: CreasedRegion) => poseOf(find, region.cause)
  for (const [i, region] of creased.entries()) {
    report(i / creased.length)
    const fit = fitDriver(prepared, region, causeOf(region))
    if (typeof fit !== 'string') {
      fitted.push(fit)
      continue
    }
    missing.push({ name: region.region.name, reason: fit })
    if (region.creases.length > 0) failed.set(region.region.name, `${[...causeOf(region)]}`)
  }
  // If the left and the right region have the same cause and one of them cannot crease, the other one is dropped too.
  for (const [i, region] of [...fitted.entries()].reverse()) {
    const { name } = region.region
    const other = name.replace(/Left$|Right$/, (side) => (side === 'Left' ? 'Right' : 'Left'))
    if (other === name || failed.get(other) !== `${[...causeOf(region)]}`) continue
    fitted.splice(i, 1)
    missing.push({ name, reason: 'its blendshapes do not crease the other side' })
  }
  const merged = isMirrored ? mergeSides(fitted, prepared) : fitted
  const regions = mostCompressed(merged, maxAreas)
  for (const { region } of merged.filter((one) => !regions.includes(one)))
    missing.push({ name: region.name, reason: `over the limit of ${maxAreas} areas` })
  const warnings: string[] = []
  const standIns = face ? standInsOf(known, hints) : []
  if (standIns.length > 0) warnings.push(`${standIns.join(', ')} stand in for ARKit's shapes`)
  return { regions, missing: isMirrored ? mergeMissingSides(missing) : missing, warnings }
}

/** Returns the most compressed regions in their original order. */
function mostCompressed(fitted: readonly FittedRegion[], count: number): FittedRegion[] {
  const kept = new Set([...fitted].sort((a, b) => b.compression - a.compression).slice(0, count))
  return fitted.filter((region) => kept.has(region))
}
