/** What `furrow/three` and `furrow/webgpu` have in common. */

export { addDrivers } from './drivers.ts'
export { ExpressionPlayer } from './ExpressionPlayer.ts'
export { type FaceScore, FaceScores } from './FaceScores.ts'
export { decodeImage, toGray } from './loader/decode-image.ts'
export { activationTrack } from './loader/key-frames.ts'
export { loadWrinkleSet } from './loader/load-wrinkle-set.ts'
export { type LoadedWrinkles, readWrinkleMaps } from './loader/read-wrinkle-maps.ts'
export { WRINKLES_DEFAULTS, type WrinkleMode, type WrinklesOptions } from './options.ts'
export { RecomputedNormals } from './RecomputedNormals.ts'
export { addMorphNormals, addMuscles } from './sources/muscles.ts'
export type { DriversOptions } from './sources/source.ts'
export { type WrinklesBase, wrinklesOf } from './wrinkles-base.ts'
