import type { Curve } from './curve.ts'

/**
 * A number that drivers read, one per face and frame. The engine measures the first three kinds, the application sets
 * `value`, and `area` is the activation of another area.
 */
export type Input =
  /** Weight of a morph target, in any spelling that `findTargets` knows. */
  | { kind: 'target'; name: string }
  /** Radians by which a joint is rotated from its rest pose relative to another (`from`), or metres between the two. */
  | {
      kind: 'joint'
      from: string
      joint: string
      measure: 'angle' | 'distance'
      /** Of an angle: measure the signed rotation about this axis only; in the frame of the joint at rest. */
      axis?: readonly [number, number, number]
    }
  /** Fraction by which the skin under an area is shortened or lengthened, averaged over the area. */
  | {
      kind: 'tension'
      area: string
      measure: 'compression' | 'stretch'
      /** In texture coordinates: measure along it only, not along the principal direction. */
      direction?: readonly [number, number]
    }
  /** A number that the application sets by name; until then `initial`, 0 by default. */
  | { kind: 'value'; name: string; initial?: number }
  /** Activation of an area, 0..1. */
  | { kind: 'area'; name: string }

/** The kinds of `Input`. */
export type InputKind = Input['kind']
/** Kinds of inputs that an engine or the application provides: all but the activations of areas. */
export type ExternalInputKind = Exclude<InputKind, 'area'>
/** Inputs of one kind. */
export type InputOf<K extends InputKind> = Extract<Input, { kind: K }>

/** One operand of an activation: the input, passed through the curve if there is one, times the weight. */
export interface InputLink {
  input: Input
  /** Positive or negative. */
  weight: number
  /** From the input to any number; none by default. */
  curve?: Readonly<Curve>
}

/**
 * How the links of one driver are combined: their sum, maximum, minimum (the skin between the brows creases when both are lowered) or
 * product (one gates the other).
 */
export type Rule = 'sum' | 'max' | 'min' | 'product'

/** What a driver adds to an area: its links, combined by the rule and passed through the curve. */
export interface AreaActivation {
  /** Name of the area. */
  area: string
  links: readonly InputLink[]
  /** Registered types may combine their links by a pure function of the links' values. */
  rule: Rule | ((values: Float64Array) => number)
  /** Outputs are 0..1. */
  curve: Readonly<Curve>
}

/** The name of an input, for people. */
export function inputName(input: Input): string {
  if (input.kind === 'joint') return `${input.measure} of joint ${input.joint}`
  return input.kind === 'tension' ? input.measure : input.name
}
