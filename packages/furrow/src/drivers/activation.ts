import type { Curve } from './curve.ts'

/**
 * A number from which drivers compute activations of areas (groups of wrinkles), for each face and frame. Inputs of kind `target`, `joint` and
 * `tension` are read from the engine. The application sets inputs of kind `value`. An input of kind `area` is the activation of another area.
 */
export type Input =
  /** Weight of a morph target. The name may have any spelling that `findTargets` knows. */
  | { kind: 'target'; name: string }
  /** Movement of a joint relative to joint `from`: rotation from the rest pose (radians), or distance between the joints (metres). */
  | {
      kind: 'joint'
      from: string
      joint: string
      measure: 'angle' | 'distance'
      /** Axis of a signed angle, in the rest frame of `joint`. Without an axis, the angle of the total rotation is measured. */
      axis?: readonly [number, number, number]
    }
  /** Mean compression or stretch of the skin of an area, as a fraction of the rest length. */
  | {
      kind: 'tension'
      area: string
      measure: 'compression' | 'stretch'
      /** Direction of measurement in texture coordinates. By default, each triangle is measured along its strongest compression or stretch. */
      direction?: readonly [number, number]
    }
  /** Number that the application sets. `initial` is its initial value, default 0. */
  | { kind: 'value'; name: string; initial?: number }
  /** Activation of an area, 0..1. */
  | { kind: 'area'; name: string }

/** Name of a kind of input. */
export type InputKind = Input['kind']
/** Kinds of inputs that the engine or the application provides. */
export type ExternalInputKind = Exclude<InputKind, 'area'>
/** Input of the kind `K`. */
export type InputOf<K extends InputKind> = Extract<Input, { kind: K }>

/** A link is an input of a driver with a curve and a weight. Its result is `weight * curve(input)`. */
export interface InputLink {
  input: Input
  /** Any number, also negative. */
  weight: number
  /** Curve that is applied to the input. Its outputs can be any numbers. Without a curve, the input is used unchanged. */
  curve?: Readonly<Curve>
}

/**
 * How the results of a driver's links are combined to one number. The `min` is large only if all results are large, e.g. if both brows are
 * lowered. The `product` is 0 if any result is 0.
 */
export type Rule = 'sum' | 'max' | 'min' | 'product'

/** How a driver activates an area: the rule combines the results of the links, and the curve converts the combined number to an activation. */
export interface AreaActivation {
  /** Name of the activated area. */
  area: string
  links: readonly InputLink[]
  /** Driver types added by `registerDriver` may use a pure function of the links' results. */
  rule: Rule | ((values: Float64Array) => number)
  /** Outputs are activations, 0..1. */
  curve: Readonly<Curve>
}

/** Returns the name of an input for warnings. */
export function inputName(input: Input): string {
  if (input.kind === 'joint') return `${input.measure} of joint ${input.joint}`
  return input.kind === 'tension' ? input.measure : input.name
}
