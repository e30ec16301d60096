import { type ReadonlySignal, signal } from '@preact/signals'
import type { Skin } from 'furrow/auto'
import { type RecognisedShape, recogniseShapesInWorker } from 'furrow/internal'

/** Recognised blendshapes of a skin. */
export interface Recognised {
  /** Skin to which the artist's corrections were applied. */
  readonly skin: Skin
  /** Meaning of each blendshape. */
  readonly shapes: readonly RecognisedShape[]
}

/** Recognises the blendshapes of a skin in a worker. A new run cancels the previous one. */
export class Recognition {
  readonly #result = signal<Recognised | null>(null)
  readonly #isRunning = signal(false)
  #abort: AbortController | null = null

  /** Latest result, or null. */
  get result(): ReadonlySignal<Recognised | null> {
    return this.#result
  }

  get isRunning(): ReadonlySignal<boolean> {
    return this.#isRunning
  }

  /** Recognises the blendshapes of a corrected skin. Rejects with a FurrowError if the worker dies. */
  async run(skin: Skin): Promise<void> {
    this.#abort?.abort()
    const abort = new AbortController()
    this.#abort = abort
    this.#isRunning.value = true
    try {
      const shapes = await recogniseShapesInWorker(skin, abort.signal)
      if (this.#abort === abort) this.#result.value = { skin, shapes }
    } catch (error) {
      if (this.#abort === abort) throw error
    } finally {
      if (this.#abort === abort) this.#isRunning.value = false
    }
  }

  /** Cancels the run and clears the result. */
  forget(): void {
    this.#abort?.abort()
    this.#abort = null
    this.#isRunning.value = false
    this.#result.value = null
  }
}
