/** Parts of a face that crease: the names of their areas, without the side. */
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

/** Part of the face that {@link autoWrinkles} wrinkles. */
export type AutoRegion = (typeof AUTO_REGIONS)[number]
