import type { Curve } from './curve.ts'

/**
 * A number that drivers read, one per face and frame. An engine measures the first three kinds, the application sets
 * `value`, and `area` is the activation of another area.
 */
export type Input =
  /** Weight of a morph target, in any spelling that `findTargets` knows. */
  | { kind: 'target'; name: string }
  /** Radians by which a joint is turned from its rest pose as seen from another, or metres between the two. */
  | {
      kind: 'joint'
      from: string
      joint: string
      measure: 'angle' | 'distance'
      /** Of an angle: count the rotation about this axis only, signed; in the frame of the joint at rest. */
      axis?: readonly [number, number, number]
    }
  /** Fraction by which the skin under an area is shortened or lengthened, averaged over the area. */
  | { kind: 'tension'; area: string; measure: 'compression' | 'stretch' }
  /** A number that the application sets by name; `initial` until it does, 0 by default. */
  | { kind: 'value'; name: string; initial?: number }
  | { kind: 'area'; name: string }

export type InputKind = Input['kind']
/** Kinds of inputs from outside the driver graph. */
export type ExternalInputKind = Exclude<InputKind, 'area'>
export type InputOf<K extends InputKind> = Extract<Input, { kind: K }>

/** One operand of an activation: the input through its curve, if there is one, times the weight. */
export interface InputLink {
  input: Input
  /** Of either sign. */
  weight: number
  curve?: Readonly<Curve>
}

/**
 * How the links of one driver are combined: added, the largest, the smallest (two brows lowered together crease the
 * middle), or multiplied (one gates the other).
 */
export type Rule = 'sum' | 'max' | 'min' | 'product'

/** What a driver adds to an area: its links, combined by the rule, through the curve. */
export interface AreaActivation {
  area: string
  links: readonly InputLink[]
  /** A registered driver may combine its links by a pure function of their values. */
  rule: Rule | ((values: Float64Array) => number)
  /** Outputs are within 0..1. */
  curve: Readonly<Curve>
}

/** The name of an input as people read it. */
export function inputName(input: Input): string {
  if (input.kind === 'joint') return `${input.measure} of joint ${input.joint}`
  return input.kind === 'tension' ? input.measure : input.name
}
