export { decodeImage, toGray } from '../three/decode-image.ts'
export { driveByMorphs } from '../three/drive.ts'
export { ExpressionPlayer } from '../three/ExpressionPlayer.ts'
export { loadWrinkleSet } from '../three/load-wrinkle-set.ts'
export { type LoadedWrinkles, readWrinkleMaps } from '../three/read-wrinkle-maps.ts'
export {
  WRINKLES_DEFAULTS,
  type WrinkleMode,
  type WrinklesBase,
  type WrinklesOptions,
  wrinklesOf,
} from '../three/Wrinkles.ts'
export { type Gradients, influenceFromMap, sampleSlice } from './influence.ts'
export { mixNormals, mixValues, reorient, type Shares } from './mix.ts'
export { WrinkleLoaderPlugin } from './WrinkleLoaderPlugin.ts'
export { Wrinkles } from './Wrinkles.ts'
