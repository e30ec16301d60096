/**
 * Engine-independent wrinkle data: wrinkle sets, activations, drivers and expressions.
 *
 * @module furrow
 */

export { type AreaConvention, areaWeights } from './core/area.ts'
export { type ErrorCode, type ErrorParts, FurrowError } from './core/error.ts'
export type { ImageArray } from './core/image-array.ts'
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
export type {
  AreaActivation,
  ExternalInputKind,
  Input,
  InputKind,
  InputLink,
  InputOf,
  Rule,
} from './drivers/activation.ts'
export type { Curve, CurvePoint } from './drivers/curve.ts'
export type { ActivationFilter, DriverDefinition, InputFilter } from './drivers/definition.ts'
export type { DriverPart, Explanation, LinkPart } from './drivers/explain.ts'
export type { Expression } from './drivers/expression/expression.ts'
export { EXPRESSIONS } from './drivers/expression/presets.ts'
export type { Fields } from './drivers/fields.ts'
export type { Link } from './drivers/link.ts'
export { ALIASES } from './drivers/morph/aliases.ts'
export { findTargets } from './drivers/morph/target-names.ts'
export type { VrmExpression, VrmExpressions } from './drivers/morph/vrm.ts'
export { muscleOffsets } from './drivers/muscle/offsets.ts'
export { driversOf } from './drivers/of-type.ts'
export { parseDrivers, parseWrinkleSetDocument, type WrinkleSetDocument } from './drivers/parse.ts'
export type * from './drivers/registry.ts'
export { registerDriver } from './drivers/registry.ts'
export { EASINGS, type Easing, type ExpressionChoice } from './runtime/expression-mix.ts'
