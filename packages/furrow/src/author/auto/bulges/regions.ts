import { type FaceContext, SIDES, type Side } from '../anatomy/region.ts'
import { type AutoRegion, BULGE_REGIONS, type BulgeName, LINE_REGIONS } from '../anatomy/region-names.ts'
import { bag } from './bag.ts'
import { BULGES_FROM } from './bulge-driver.ts'
import type { BulgeRegion } from './bulge-region.ts'
import { cheek } from './cheek.ts'
import { hood } from './hood.ts'
import { jowl } from './jowl.ts'

const PARTS: Record<BulgeName, (context: FaceContext, side: Side, name: string) => BulgeRegion> = {
  bag,
  hood,
  cheek,
  jowl,
}

/** Returns the regions in a list that a face of an age has. Bulges are left out until they show. */
export function regionsAt(years: number | undefined, wanted: readonly AutoRegion[]): readonly AutoRegion[] {
  if (years !== undefined && years > BULGES_FROM) return wanted
  return LINE_REGIONS.filter((region) => wanted.includes(region))
}

/** Returns the regions in a list that bulge with age, for both sides of a face. */
export function bulgeRegions(context: FaceContext, wanted: readonly AutoRegion[]): BulgeRegion[] {
  return BULGE_REGIONS.filter((region) => wanted.includes(region)).flatMap((region) =>
    SIDES.map(([side, name]) => PARTS[region](context, side, name)),
  )
}
