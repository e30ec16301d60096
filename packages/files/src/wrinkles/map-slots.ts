/** Maps of a layer: name in a folder, and property in the extension. */
export const MAP_SLOTS = [
  ['normal', 'normalTexture'],
  ['baseColor', 'baseColorTexture'],
  ['roughness', 'roughnessTexture'],
  ['occlusion', 'occlusionTexture'],
  ['height', 'heightTexture'],
  ['blood', 'bloodTexture'],
] as const

/** Name of a layer's map in a folder. */
export type MapName = (typeof MAP_SLOTS)[number][0]
