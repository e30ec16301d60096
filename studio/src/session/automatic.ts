import { type ReadonlySignal, signal } from '@preact/signals'
import { type AutoOptions, type AutoWrinkles, autoWrinklesInWorker } from 'furrow/auto'
import type { SkinSource } from '../open/skin-source.ts'

/** Progress of making automatic wrinkles. */
export interface AutoRun {
  readonly step: string
  /** Progress, 0..1. */
  readonly fraction: number
}

/** Makes automatic wrinkles in a worker. A new run cancels the previous one. */
export class Automatic {
  readonly #run = signal<AutoRun | null>(null)
  #abort: AbortController | null = null

  get run(): ReadonlySignal<AutoRun | null> {
    return this.#run
  }

  /** Makes wrinkles for a skin. Returns null if the run was cancelled. Rejects with errors of `autoWrinkles`. */
  async make(
    { skin, frame }: Pick<SkinSource, 'skin' | 'frame'>,
    options: AutoOptions,
  ): Promise<AutoWrinkles | null> {
    this.cancel()
    const abort = new AbortController()
    this.#abort = abort
    this.#run.value = { step: 'starting', fraction: 0 }
    const progress = (done: number, total: number, step: string) => {
      if (this.#abort === abort) this.#run.value = { step, fraction: done / total }
    }
    try {
      return await autoWrinklesInWorker(skin, { ...options, frame, progress, signal: abort.signal })
    } catch (error) {
      if (abort.signal.aborted) return null
      throw error
    } finally {
      if (this.#abort === abort) this.#end()
    }
  }

  cancel(): void {
    this.#abort?.abort()
    this.#end()
  }

  #end(): void {
    this.#abort = null
    this.#run.value = null
  }
}
