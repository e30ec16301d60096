/** What `furrow/three` and `furrow/webgpu` have in common. */
export { decodeImage, toGray } from './decode-image.ts'
export { addDrivers } from './drivers.ts'
export { ExpressionPlayer } from './ExpressionPlayer.ts'
export { loadWrinkleSet } from './load-wrinkle-set.ts'
export { WRINKLES_DEFAULTS, type WrinkleMode, type WrinklesOptions } from './options.ts'
export { type LoadedWrinkles, readWrinkleMaps } from './read-wrinkle-maps.ts'
export { type WrinklesBase, wrinklesOf } from './Wrinkles.ts'
