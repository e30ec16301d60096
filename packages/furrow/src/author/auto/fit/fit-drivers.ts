import type { CreasedRegion } from '../lines/crease.ts'
import { poseOf } from '../surface/pose.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { standInsOf } from '../surface/stand-ins.ts'
import { mergeSides, withoutSides } from './both-sides.ts'
import { type FittedRegion, fitDriver, type MissingRegion } from './fit-driver.ts'

/** The regions that get an area, and those that do not. */
export interface FittedSkin {
  regions: readonly FittedRegion[]
  missing: readonly MissingRegion[]
  /** One sentence each. */
  warnings: readonly string[]
}

/**
 * Fits a driver to each region.
 *
 * @param maxAreas regions at most; those with the least compression are left out.
 * @param report is given the fraction that is done.
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
  /** Causes of regions that have skin and get no area. */
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
  // One cause of both sides creases both, or neither.
  for (const [i, region] of [...fitted.entries()].reverse()) {
    const { name } = region.region
    const other = name.replace(/Left$|Right$/, (side) => (side === 'Left' ? 'Right' : 'Left'))
    if (other === name || failed.get(other) !== `${[...causeOf(region)]}`) continue
    fitted.splice(i, 1)
    missing.push({ name, reason: 'what causes it does not crease the other side' })
  }
  const merged = isMirrored ? mergeSides(fitted, prepared) : fitted
  const regions = mostCompressed(merged, maxAreas)
  for (const { region } of merged.filter((one) => !regions.includes(one)))
    missing.push({ name: region.name, reason: `more than ${maxAreas} areas would be needed` })
  const warnings: string[] = []
  const standIns = face ? standInsOf(known, hints) : []
  if (standIns.length > 0) warnings.push(`${standIns.join(', ')} stand in for ARKit's shapes`)
  return { regions, missing: isMirrored ? withoutSides(missing) : missing, warnings }
}

/** Those with the most compression, in their order. */
function mostCompressed(fitted: readonly FittedRegion[], count: number): FittedRegion[] {
  const kept = new Set([...fitted].sort((a, b) => b.compression - a.compression).slice(0, count))
  return fitted.filter((region) => kept.has(region))
}
