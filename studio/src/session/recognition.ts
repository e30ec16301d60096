import { type ReadonlySignal, signal } from '@preact/signals'
import type { Skin } from 'furrow/auto'
import { type RecognisedShape, recogniseShapesInWorker } from 'furrow/internal'

/** The recognised blendshapes of a skin. */
export interface Recognised {
  /** With corrections. */
  readonly skin: Skin
  /** One entry per blendshape. */
  readonly shapes: readonly RecognisedShape[]
}

/** Recognises the blendshapes of a skin in a worker, one run at a time: a new run ends the last one. */
export class Recognition {
  readonly #result = signal<Recognised | null>(null)
  readonly #isRunning = signal(false)
  #abort: AbortController | null = null

  /** The last result; null before there is one. */
  get result(): ReadonlySignal<Recognised | null> {
    return this.#result
  }

  get isRunning(): ReadonlySignal<boolean> {
    return this.#isRunning
  }

  /** Recognises the blendshapes of a skin with its corrections. Rejects with a FurrowError where the worker dies. */
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

  /** Ends the run, and forgets the result. */
  forget(): void {
    this.#abort?.abort()
    this.#abort = null
    this.#isRunning.value = false
    this.#result.value = null
  }
}
