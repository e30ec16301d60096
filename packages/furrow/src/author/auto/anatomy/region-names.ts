/** Regions of a face that get wrinkle lines. */
export const LINE_REGIONS = [
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

/** Regions of a face that bulge with age: bags under the eyes, hoods of the upper lids, cheeks over the nasolabial folds, and jowls. */
export const BULGE_REGIONS = ['bag', 'hood', 'cheek', 'jowl'] as const

/**
 * Regions of a face that get wrinkles or bulges. A region's area of influence has the region's name, followed by `Left` or `Right` if the two
 * halves of the face have separate areas.
 */
export const AUTO_REGIONS = [...LINE_REGIONS, ...BULGE_REGIONS] as const

/** Name of a region of the face for which {@link autoWrinkles} makes wrinkles or bulges. */
export type AutoRegion = (typeof AUTO_REGIONS)[number]

/** Name of a region of the face, or of its left or right half. */
export type AutoSide = AutoRegion | `${AutoRegion}${'Left' | 'Right'}`

/** Regions that have one area of influence for both halves of the face. */
const MIDDLE_REGIONS: readonly AutoRegion[] = ['noseRoot', 'upperLip', 'lowerLip', 'chin', 'neck']

/** Returns the names of a region's areas of influence. */
export function sidesOf(region: AutoRegion): readonly AutoSide[] {
  return MIDDLE_REGIONS.includes(region) ? [region] : [`${region}Left`, `${region}Right`]
}

/** Names of the regions of the face, and of their left and right halves. */
export const AUTO_SIDES: readonly AutoSide[] = [
  ...new Set([...AUTO_REGIONS, ...AUTO_REGIONS.flatMap((region) => sidesOf(region))]),
]

/** Regions with many lines, whose number can be chosen. The lines of `foreheadInner` belong to the whole forehead. */
export const DENSE_REGIONS = [
  'foreheadInner',
  'nose',
  'crowsFeet',
  'underEye',
  'upperLip',
  'lowerLip',
] as const satisfies readonly AutoRegion[]

/** Name of a region with many lines. */
export type DenseRegion = (typeof DENSE_REGIONS)[number]

/** Name of a region that bulges with age. */
export type BulgeName = (typeof BULGE_REGIONS)[number]
