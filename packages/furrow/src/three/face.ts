import { Activations } from '../core/activations.ts'
import type { AreaArray } from './area-array.ts'
import type { AtlasFace } from './influence-atlas.ts'

/** One face: a mesh, or one instance of it, with activations of its own. */
export class Face implements AtlasFace {
  areas: AreaArray
  readonly activations: Activations
  readonly #drive: () => void

  /** @param drive brings the activations up to date with whatever moves them. */
  constructor(areas: AreaArray, named: readonly { name: string; activation?: number }[], drive: () => void) {
    this.areas = areas
    this.activations = new Activations(named, 'Wrinkles')
    for (const { name, activation } of named) this.activations.set(name, activation ?? 0)
    this.#drive = drive
  }

  get values(): Float32Array {
    return this.activations.values
  }

  drive(): void {
    this.#drive()
  }
}
