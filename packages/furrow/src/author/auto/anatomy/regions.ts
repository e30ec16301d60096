import { chinAndNeck } from './chin.ts'
import { eyes } from './eyes.ts'
import { forehead } from './forehead.ts'
import { frown } from './frown.ts'
import { mouth } from './mouth.ts'
import { nose } from './nose.ts'
import type { Build, Region } from './region.ts'

/** Parts of a face that crease: names of areas without their side. */
export const AUTO_REGIONS = [
  'foreheadInner',
  'foreheadOuter',
  'glabella',
  'noseRoot',
  'nose',
  'crowsFeet',
  'underEye',
  'nasolabial',
  'mouthCorner',
  'upperLip',
  'lowerLip',
  'chin',
  'neck',
] as const

/** A part of the face whose wrinkles {@link autoWrinkles} makes. */
export type AutoRegion = (typeof AUTO_REGIONS)[number]

/** The parts that are wanted, both sides of each. */
export function regionsOf(build: Build, wanted: readonly AutoRegion[]): Region[] {
  const names = new Set<string>(wanted)
  return [forehead, frown, nose, eyes, mouth, chinAndNeck]
    .flatMap((part) => part(build))
    .filter(({ name }) => names.has(name.replace(/(Left|Right)$/, '')))
}
