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
  parseWrinkleMaps,
  type TextureReference,
  WRINKLE_MAPS,
  type WrinkleMaps,
  type WrinkleMapsArea,
  type WrinkleMapsLayer,
} from './core/wrinkle-maps.ts'
export { checkWrinkleSet } from './core/wrinkle-set.ts'
export { AGES, AgeActivation } from './drivers/age.ts'
export { ALIASES } from './drivers/aliases.ts'
export { AreaActivation } from './drivers/area.ts'
export { BoneActivation } from './drivers/bone.ts'
export { Conflicts } from './drivers/conflict.ts'
export { curveAt } from './drivers/curve.ts'
export type { Driver } from './drivers/driver.ts'
export { type Explanation, explain, type LinkPart, type Part } from './drivers/explain.ts'
export {
  EASINGS,
  type Easing,
  type Expression,
  type ExpressionChoice,
  ExpressionMix,
  expressionsOf,
} from './drivers/expression.ts'
export { EXPRESSIONS } from './drivers/expressions.ts'
export { type ActivationPointer, parseActivationPointer } from './drivers/key-frames.ts'
export { MorphActivation } from './drivers/morph.ts'
export { muscleLinks, muscleOffsets } from './drivers/muscles.ts'
export { parseDrivers } from './drivers/read.ts'
export { type DriverState, DriverSum } from './drivers/sum.ts'
export { canonicalTargetName, findTargets } from './drivers/target-names.ts'
export { TensionActivation, type TensionSample } from './drivers/tension.ts'
export { type SampledMesh, sampleTriangles } from './drivers/tension-samples.ts'
export { Delay } from './drivers/time.ts'
export {
  type AgeDriver,
  type AreaDriver,
  type BoneDriver,
  type ConflictDriver,
  type Curve,
  type CurvePoint,
  DRIVER_TYPES,
  type DriverOf,
  type DriverType,
  driversOf,
  type ExpressionDriver,
  isKnownDriver,
  type Link,
  type MorphDriver,
  type MuscleDriver,
  type Rule,
  type TensionDriver,
  type TimeDriver,
  type WrinkleDriver,
} from './drivers/types.ts'
export { type VrmExpression, type VrmExpressions, VrmWeights } from './drivers/vrm.ts'
export { DeformedNormals, morphNormalDeltas, type RestMesh } from './math/deformed-normals.ts'
export { Activations } from './runtime/activations.ts'
