/** The maps of a layer: their names in a folder, and in the extension. */
export const MAP_SLOTS = [
  ['normal', 'normalTexture'],
  ['baseColor', 'baseColorTexture'],
  ['roughness', 'roughnessTexture'],
  ['occlusion', 'occlusionTexture'],
  ['height', 'heightTexture'],
  ['blood', 'bloodTexture'],
] as const

/** The name of a map of a layer in a folder. */
export type MapName = (typeof MAP_SLOTS)[number][0]
