import type { CreasedRegion } from '../lines/crease.ts'
import { poseOf } from '../surface/pose.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { standInsOf } from '../surface/stand-ins.ts'
import { mergeSides } from './both-sides.ts'
import { type FittedRegion, fitDriver } from './fit-driver.ts'

/** The regions that get an area, and what the user should know about the others. */
export interface FittedSkin {
  regions: readonly FittedRegion[]
  /** One sentence each. */
  warnings: readonly string[]
}

/**
 * Fits a driver to each region.
 *
 * @param maxAreas regions at most; those with the least compression are left out.
 */
export function fitDrivers(
  prepared: PreparedSkin,
  creased: readonly CreasedRegion[],
  maxAreas: number,
): FittedSkin {
  const { face, names, find, isMirrored } = prepared
  const fitted = creased.flatMap(
    (region) => fitDriver(prepared, region, poseOf(find, region.region.cause)) ?? [],
  )
  const regions = mostCompressed(isMirrored ? mergeSides(fitted, prepared) : fitted, maxAreas)
  const warnings: string[] = []
  if (regions.length === 0) warnings.push('no blendshape pushes the skin together enough to crease it')
  const standIns = face ? standInsOf(names) : []
  if (standIns.length > 0) {
    const unmoved = creased.filter(({ region }) => !fitted.some((fit) => fit.region === region))
    const smooth = unmoved.map(({ region }) => region.name).join(', ')
    warnings.push(
      `${standIns.join(', ')} stand in for ARKit's shapes${smooth && `; none moves these, which stay smooth: ${smooth}`}`,
    )
  }
  return { regions, warnings }
}

/** Those with the most compression, in their order. */
function mostCompressed(fitted: readonly FittedRegion[], count: number): FittedRegion[] {
  const kept = new Set([...fitted].sort((a, b) => b.compression - a.compression).slice(0, count))
  return fitted.filter((region) => kept.has(region))
}
