import { checkOptionNames } from '../core/nearest-name.ts'
import type { ExpressionChoice } from '../runtime/expression-mix.ts'
import type { ReliefMode, WrinkleMode } from '../three/options.ts'

/** State of faces that a React component sets. Removing a property restores its original value. */
export interface WrinkleState {
  /** Activations by area name, 0..1. Unknown names are ignored. */
  activations?: Readonly<Record<string, number>>
  /** Numbers that drivers read, by name, for example `age` in years. */
  inputs?: Readonly<Record<string, number>>
  /** Name of an expression, or weights (0..1) of several expressions by name. If omitted, the page controls the blendshapes. */
  expression?: ExpressionChoice
  /** Shading mode. */
  mode?: WrinkleMode
  /** Whether the layers' height maps displace the surface: never, near the camera, or always. */
  relief?: ReliefMode
}

/** Names of all properties of `WrinkleState`. */
const NAMES: Record<keyof WrinkleState, true> = {
  activations: true,
  inputs: true,
  expression: true,
  mode: true,
  relief: true,
}

/** @throws FurrowError if a property is unknown. */
export function checkState(state: WrinkleState): void {
  checkOptionNames(state, Object.keys(NAMES), 'Wrinkles')
}
