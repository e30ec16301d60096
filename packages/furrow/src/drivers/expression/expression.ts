import { driversOf, type WrinkleDriver } from '../registry.ts'

/** A pose of a face: weights of blendshapes and activations of areas. */
export interface Expression {
  name: string
  /** Blendshape weights by ARKit's names, 0..1; others are 0. */
  targets: Readonly<Record<string, number>>
  /** Activations by area, 0..1; others are 0. */
  activations: Readonly<Record<string, number>>
}

/** The presets among a file's drivers. */
export function expressionsOf(drivers: readonly WrinkleDriver[]): Expression[] {
  return driversOf('expression', drivers).map(({ name, targets, activations }) => ({
    name,
    targets: Object.fromEntries(targets.map(({ name, weight }) => [name, weight])),
    activations: Object.fromEntries(activations.map(({ area, activation }) => [area, activation])),
  }))
}
