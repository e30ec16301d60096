export { Activations } from './core/activations.ts'
export { type AreaConvention, areaWeights } from './core/area.ts'
export {
  parseWrinkleSetDocument,
  type WrinkleSetDocument,
} from './core/document.ts'
export { FurrowError } from './core/error.ts'
export { resampleGray } from './core/image.ts'
export { DEFAULT_AREA_SIZE, MAX_AREAS, MAX_IMAGE_SIDE, MAX_LAYERS } from './core/limits.ts'
export { type ImageArray, packAreas, packColours, packGrays } from './core/pack.ts'
export * as reference from './core/reference.ts'
export type {
  Area,
  ArraySlice,
  Combine,
  GrayImage,
  Layer,
  LayerKind,
  RgbaImage,
  WrinkleSet,
} from './core/types.ts'
export {
  isMorphDriver,
  type MorphDriver,
  parseWrinkleMaps,
  type TextureReference,
  WRINKLE_MAPS,
  type WrinkleDriver,
  type WrinkleMaps,
  type WrinkleMapsArea,
  type WrinkleMapsLayer,
} from './core/wrinkle-maps.ts'
export { checkWrinkleSet } from './core/wrinkle-set.ts'
export { type Expression, ExpressionMix } from './drivers/expression.ts'
export { EXPRESSIONS } from './drivers/expressions.ts'
export { curveAt, MorphActivation } from './drivers/morph.ts'
export { canonicalTargetName, findTargets } from './drivers/target-names.ts'
