import { checkOptionNames } from '../core/nearest-name.ts'
import type { ExpressionChoice } from '../runtime/expression-mix.ts'
import type { ReliefMode, WrinkleMode } from '../three/options.ts'

/** Declared state of faces. Removing a property restores its original value. */
export interface WrinkleState {
  /** Activations by area name, 0..1. Unknown names are ignored. */
  activations?: Readonly<Record<string, number>>
  /** Custom inputs of drivers by name, e.g. `age` in years. */
  inputs?: Readonly<Record<string, number>>
  /** Expression name, or weights (0..1) by name. If omitted, the page controls the blendshapes. */
  expression?: ExpressionChoice
  /** Shading mode. */
  mode?: WrinkleMode
  /** When the layers' heights displace the surface. */
  relief?: ReliefMode
}

/** Property names, checked for completeness by the type. */
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
