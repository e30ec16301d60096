import type { ReadonlySignal } from '@preact/signals'
import type { Viewer } from '../viewer/viewer.ts'

/** Shows areas fully while their skin is sculpted, whatever expression the face has. */
export class RevealedAreas {
  readonly #viewer: ReadonlySignal<Viewer | null>
  /** Activations before the areas were shown, by name. */
  readonly #before = new Map<string, number>()

  constructor(viewer: ReadonlySignal<Viewer | null>) {
    this.#viewer = viewer
  }

  /** Shows areas until `end`. Ignores areas that the face does not have. */
  show(names: readonly string[]): void {
    for (const { name, read, write } of this.#viewer.peek()?.areas ?? []) {
      const activation = read()
      if (!names.includes(name) || activation === 1) continue
      if (!this.#before.has(name)) this.#before.set(name, activation)
      write(1)
    }
  }

  /** Restores all activations. Drivers then set those of their areas for the current pose. */
  end(): void {
    const viewer = this.#viewer.peek()
    if (this.#before.size === 0) return
    for (const { name, write } of viewer?.areas ?? []) {
      const activation = this.#before.get(name)
      if (activation !== undefined) write(activation)
    }
    this.#before.clear()
    viewer?.driven.drive()
  }
}
