import { checkOptionNames } from '../core/nearest-name.ts'
import type { ExpressionChoice } from '../runtime/expression-mix.ts'
import type { ReliefMode, WrinkleMode } from '../three/options.ts'

/** What properties say of faces. A property that is taken away returns to what it was before. */
export interface WrinkleState {
  /** Activations of areas by name, 0..1; names that a face does not have are ignored. */
  activations?: Readonly<Record<string, number>>
  /** Numbers for drivers by name, such as `age` in years. */
  inputs?: Readonly<Record<string, number>>
  /** An expression, or several with weights, 0..1. Without it, the page moves the blendshapes. */
  expression?: ExpressionChoice
  /** How wrinkles are shown. */
  mode?: WrinkleMode
  /** Whether the layers' heights move the surface. */
  relief?: ReliefMode
}

/** Names of the properties. */
const NAMES: Record<keyof WrinkleState, true> = {
  activations: true,
  inputs: true,
  expression: true,
  mode: true,
  relief: true,
}

/** @throws FurrowError at the first property that does not exist. */
export function checkState(state: WrinkleState): void {
  checkOptionNames(state, Object.keys(NAMES), 'Wrinkles')
}
