import { driversOf } from '../of-type.ts'
import type { WrinkleDriver } from '../registry.ts'

/** A facial expression: weights of blendshapes and activations of areas. */
export interface Expression {
  /** Name for `play`. */
  name: string
  /** Blendshape weights, 0..1, by name in any spelling that `findTargets` knows; other blendshapes are 0. */
  targets: Readonly<Record<string, number>>
  /** Activations by area, 0..1; other areas are at rest. */
  activations: Readonly<Record<string, number>>
}

/** Returns the expressions among a file's drivers. */
export function expressionsOf(drivers: readonly WrinkleDriver[]): Expression[] {
  return driversOf('expression', drivers).map(({ name, targets, activations }) => ({
    name,
    targets: Object.fromEntries(targets.map(({ name, weight }) => [name, weight])),
    activations: Object.fromEntries(activations.map(({ area, activation }) => [area, activation])),
  }))
}
