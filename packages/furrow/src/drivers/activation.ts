import type { Curve } from './curve.ts'

/**
 * A number that drivers read, one per face and frame. The engine measures the first three kinds, the application sets `value`, and
 * `area` is the activation of another area.
 */
export type Input =
  /** Weight of a morph target, in any spelling that `findTargets` knows. */
  | { kind: 'target'; name: string }
  /** Rotation of a joint from its rest pose relative to joint `from`, radians, or distance between the two, metres. */
  | {
      kind: 'joint'
      from: string
      joint: string
      measure: 'angle' | 'distance'
      /** Angle only: axis of the signed rotation, in the rest frame of the joint. Default: total rotation. */
      axis?: readonly [number, number, number]
    }
  /** Mean compression or stretch of the skin under an area, as a fraction of the rest length. */
  | {
      kind: 'tension'
      area: string
      measure: 'compression' | 'stretch'
      /** Direction of measurement in texture coordinates; default: the principal direction. */
      direction?: readonly [number, number]
    }
  /** Custom input: a number set by the application; `initial` until then, default 0. */
  | { kind: 'value'; name: string; initial?: number }
  /** Activation of an area, 0..1. */
  | { kind: 'area'; name: string }

/** The kinds of `Input`. */
export type InputKind = Input['kind']
/** Kinds of inputs that an engine or the application provides: all but the activations of areas. */
export type ExternalInputKind = Exclude<InputKind, 'area'>
/** Inputs of one kind. */
export type InputOf<K extends InputKind> = Extract<Input, { kind: K }>

/** Operand of an activation: the input, passed through the optional curve, times the weight. */
export interface InputLink {
  input: Input
  /** Positive or negative. */
  weight: number
  /** Optional curve from the input to any number. */
  curve?: Readonly<Curve>
}

/**
 * How the links of a driver are combined. With `min` all links must be active, e.g. both brows lowered; with `product` one link gates the
 * others.
 */
export type Rule = 'sum' | 'max' | 'min' | 'product'

/** Contribution of a driver to an area: links combined by the rule, passed through the curve. */
export interface AreaActivation {
  /** Name of the area. */
  area: string
  links: readonly InputLink[]
  /** Registered types may use a pure function of the link values. */
  rule: Rule | ((values: Float64Array) => number)
  /** Outputs are 0..1. */
  curve: Readonly<Curve>
}

/** Returns the name of an input for messages. */
export function inputName(input: Input): string {
  if (input.kind === 'joint') return `${input.measure} of joint ${input.joint}`
  return input.kind === 'tension' ? input.measure : input.name
}
