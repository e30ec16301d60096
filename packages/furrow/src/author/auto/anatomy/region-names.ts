/** Regions of a face that crease. A region's area has the same name, followed by `Left` or `Right` if both sides have an area. */
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

/** Name of a region of the face for which {@link autoWrinkles} makes wrinkles. */
export type AutoRegion = (typeof AUTO_REGIONS)[number]
