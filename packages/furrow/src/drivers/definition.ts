import type { Curve } from './curve.ts'
import type { Fields } from './fields.ts'

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

/** Changes inputs before any driver reads them. */
export interface InputFilter {
  inputs: readonly Input[]
  /**
   * @param indices per input: where its values are; it is their mean.
   * @returns a function that changes the values in place. It runs once per face and frame and should not allocate.
   */
  bind(indices: readonly Uint16Array[]): (values: Float64Array) => void
}

/** Changes an area's activation after all drivers have run, with memory of the frame before. */
export interface ActivationFilter {
  area: string
  /**
   * @param index of the area.
   * @returns a function that reads and writes `activations[index]` and `previous[index]`, the result of the last frame;
   *   `seconds[0]` is the time since then. It runs once per face and frame and should not allocate.
   */
  bind(index: number): (activations: Float32Array, previous: Float64Array, seconds: Float64Array) => void
}

/**
 * All that a type of driver is. Its JSON Schema is `schema.json` in the same folder. A driver activates an area, filters
 * inputs, filters an activation, or does none of these and is data for somebody else.
 */
export interface DriverDefinition<D extends { type: string } = { type: string }> {
  readonly type: D['type']
  /** Reads the fields from JSON; throws FurrowError by `fields` where one is wrong. */
  read(fields: Fields): Omit<D, 'type'>
  /** One line for people. */
  describe(driver: D): string
  activate?(driver: D): AreaActivation | undefined
  filterInputs?(driver: D): InputFilter
  filterActivation?(driver: D): ActivationFilter
}

/** The name of an input as people read it. */
export function inputName(input: Input): string {
  if (input.kind === 'joint') return `${input.measure} of joint ${input.joint}`
  return input.kind === 'tension' ? input.measure : input.name
}
