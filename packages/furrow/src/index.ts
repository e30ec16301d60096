/**
 * The data of wrinkles and what drives them, without an engine: wrinkle sets, activations, drivers and expressions.
 *
 * @module furrow
 */

export { type ActivationPointer, parseActivationPointer } from './core/activation-pointer.ts'
export { type AreaConvention, areaWeights } from './core/area.ts'
export { BLOOD_ABSORPTION, BLOOD_AT_REST, MAX_BLOOD_AMPLITUDE } from './core/blood.ts'
export { type ErrorCode, type ErrorParts, FurrowError } from './core/error.ts'
export { resampleGray } from './core/image.ts'
export type { ImageArray } from './core/image-array.ts'
export {
  DEFAULT_AREA_SIZE,
  LONGEST_NAME,
  MAX_AREAS,
  MAX_IMAGE_BYTES,
  MAX_IMAGE_SIDE,
  MAX_LAYERS,
} from './core/limits.ts'
export { checkDeclared, WRINKLE_MAPS } from './core/maps/declared.ts'
export { DecodedBytes } from './core/maps/decoded-bytes.ts'
export { imageDamage } from './core/maps/image-file.ts'
export { type ImageFileType, imageTypeOf } from './core/maps/image-type.ts'
export {
  type Ktx2Fault,
  type Ktx2Header,
  type Ktx2Image,
  readKtx2Header,
  readKtx2Image,
} from './core/maps/ktx2-header.ts'
export {
  drawnTextures,
  type MapProblem,
  mapProblems,
  type TextureShape,
  texturesOfFace,
} from './core/maps/rules.ts'
export type {
  MapsAndAreas,
  TextureReference,
  WrinkleMapsArea,
  WrinkleMapsLayer,
} from './core/maps/wrinkle-maps.ts'
export { isName } from './core/name.ts'
export { packAreas, packColours, packGrays } from './core/pack.ts'
/** The paper's formulas in float64 on the CPU, which every GPU path is compared with. */
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
export { checkWrinkleSet } from './core/wrinkle-set.ts'
export type {
  AreaActivation,
  ExternalInputKind,
  Input,
  InputKind,
  InputLink,
  InputOf,
  Rule,
} from './drivers/activation.ts'
export { AGES, type AgeDriver } from './drivers/age/definition.ts'
export { JointMeasurement } from './drivers/bone/measure.ts'
export type { Contribution } from './drivers/contribution.ts'
export { type Curve, type CurvePoint, curveAt } from './drivers/curve.ts'
export type { ActivationFilter, DriverDefinition, InputFilter } from './drivers/definition.ts'
export { describeDriver, describeLink } from './drivers/describe.ts'
export {
  type Explanation,
  explain,
  type LinkPart,
  needsMesh,
  type Part,
  type Situation,
} from './drivers/explain.ts'
export { type Expression, expressionsOf } from './drivers/expression/expression.ts'
export { EXPRESSIONS } from './drivers/expression/presets.ts'
export type { Fields } from './drivers/fields.ts'
export type { Link } from './drivers/link.ts'
export { ALIASES } from './drivers/morph/aliases.ts'
export { canonicalTargetName, findTargets } from './drivers/morph/target-names.ts'
export { type VrmExpression, type VrmExpressions, VrmWeights } from './drivers/morph/vrm.ts'
export { muscleOffsets } from './drivers/muscle/offsets.ts'
export { driversOf } from './drivers/of-type.ts'
export {
  parseDrivers,
  parseWrinkleMaps,
  parseWrinkleSetDocument,
  type WrinkleMaps,
  type WrinkleSetDocument,
} from './drivers/parse.ts'
export { type DriverPlan, type PlannedActivation, type PlannedFilter, planDrivers } from './drivers/plan.ts'
export {
  type BoundInput,
  DriverProgram,
  type DriverState,
  type InputSource,
  type InputSources,
} from './drivers/program.ts'
export type * from './drivers/registry.ts'
export { DRIVER_TYPES, isKnownDriver, registerDriver } from './drivers/registry.ts'
export { measuredSource, targetSource, valueSource } from './drivers/sources.ts'
export { TensionMeasurement, type TensionSample } from './drivers/tension/measure.ts'
export { type SampledMesh, sampleTriangles } from './drivers/tension/samples.ts'
export { DeformedNormals, morphNormalDeltas, type RestMesh } from './math/deformed-normals.ts'
export { Activations } from './runtime/activations.ts'
export { EASINGS, type Easing, type ExpressionChoice, ExpressionMix } from './runtime/expression-mix.ts'
