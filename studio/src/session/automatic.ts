import { type ReadonlySignal, signal } from '@preact/signals'
import { type AutoOptions, type AutoWrinkles, autoWrinklesInWorker } from 'furrow/auto'
import type { SkinSource } from '../open/skin-source.ts'

/** How far a run is. */
export interface AutoRun {
  readonly step: string
  /** 0..1. */
  readonly fraction: number
}

/** Makes automatic wrinkles in a worker, one run at a time: a new run ends the last one. */
export class Automatic {
  readonly #run = signal<AutoRun | null>(null)
  #abort: AbortController | null = null

  /** Null while nothing is made. */
  get run(): ReadonlySignal<AutoRun | null> {
    return this.#run
  }

  /** @returns the wrinkles, null where the run was ended. Rejects with what `autoWrinkles` throws. */
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

  /** Ends the run, if there is one. */
  cancel(): void {
    this.#abort?.abort()
    this.#end()
  }

  #end(): void {
    this.#abort = null
    this.#run.value = null
  }
}
