import { driversOf } from '../of-type.ts'
import type { WrinkleDriver } from '../registry.ts'

/** A facial expression: blendshape weights and activations of areas. */
export interface Expression {
  /** Name that `ExpressionPlayer.play` accepts. */
  name: string
  /** Blendshape weights, 0..1, by name, in any spelling that `findTargets` knows. Blendshapes that are not listed have weight 0. */
  targets: Readonly<Record<string, number>>
  /** Activations, 0..1, by name of the area. Areas that are not listed have their resting activation. */
  activations: Readonly<Record<string, number>>
}

/** Converts all drivers of type `expression` to expressions. */
export function expressionsOf(drivers: readonly WrinkleDriver[]): Expression[] {
  return driversOf('expression', drivers).map(({ name, targets, activations }) => ({
    name,
    targets: Object.fromEntries(targets.map(({ name, weight }) => [name, weight])),
    activations: Object.fromEntries(activations.map(({ area, activation }) => [area, activation])),
  }))
}
