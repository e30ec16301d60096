import { Activations } from '../runtime/activations.ts'
import type { AreaArray } from './atlas/area-array.ts'
import type { AnyRenderer, AtlasFace } from './atlas/influence-atlas.ts'

/** One face: a mesh, or one instance of it, with activations of its own. */
export class Face implements AtlasFace {
  areas: AreaArray
  readonly activations: Activations
  /** Activations at rest, to which drivers add. */
  readonly resting: Activations
  readonly #drive: (face: Face, renderer: AnyRenderer) => void

  /** @param drive brings the activations up to date with whatever moves them. */
  constructor(
    areas: AreaArray,
    named: readonly { name: string; activation?: number }[],
    drive: (face: Face, renderer: AnyRenderer) => void,
  ) {
    this.areas = areas
    this.activations = new Activations(named, 'Wrinkles')
    this.resting = new Activations(named, 'Wrinkles')
    for (const { name, activation } of named) this.rest(name, activation ?? 0)
    this.#drive = drive
  }

  /** Sets an activation at rest, which shows until a driver says more. */
  rest(area: string, value: number): void {
    this.resting.set(area, value)
    this.activations.set(area, value)
  }

  /** Takes another list of areas; those whose names stay keep their activations. */
  rebind(areas: AreaArray, named: readonly { name: string }[]): void {
    this.areas = areas
    this.activations.rebind(named)
    this.resting.rebind(named)
  }

  get values(): Float32Array {
    return this.activations.values
  }

  drive(renderer: AnyRenderer): void {
    this.#drive(this, renderer)
  }
}
