/** Maps of a layer: name of the image file in a folder, and name of the property in FURROW_wrinkle_maps. */
export const MAP_SLOTS = [
  ['normal', 'normalTexture'],
  ['baseColor', 'baseColorTexture'],
  ['roughness', 'roughnessTexture'],
  ['occlusion', 'occlusionTexture'],
  ['height', 'heightTexture'],
  ['blood', 'bloodTexture'],
  ['onset', 'onsetTexture'],
] as const

/** Name of a map, which is also its file name without extension. */
export type MapName = (typeof MAP_SLOTS)[number][0]
