import type { ResultLine } from './results.ts'

export interface BatchCounts {
  inputs: number
  /** Inputs that succeeded in this run or an earlier one. */
  done: number
  failed: number
  /** Inputs that succeeded with warnings. */
  warned: number
  /** Inputs whose result is from an earlier run. */
  kept: number
  /** Inputs with the same content as another input. */
  shared: number
}

export function countsOf(lines: readonly ResultLine[], kept: number): BatchCounts {
  const done = lines.filter(({ status }) => status === 'done')
  return {
    inputs: lines.length,
    done: done.length,
    failed: lines.length - done.length,
    warned: done.filter(({ warnings }) => warnings.length > 0).length,
    kept,
    shared: lines.filter(({ sameAs }) => sameAs !== undefined).length,
  }
}

export function countsText({ inputs, done, failed, warned, kept, shared }: BatchCounts): string {
  const parts = [
    `${done} of ${inputs} done`,
    failed > 0 && `${failed} failed`,
    warned > 0 && `${warned} with warnings`,
    shared > 0 && `${shared} identical to others`,
    kept > 0 && `${kept} from an earlier run`,
  ]
  return parts.filter((part) => part !== false).join(', ')
}

/** Formats the rate and the remaining time of a batch for the progress bar. */
export class Rate {
  readonly #start: number

  constructor(now: number) {
    this.#start = now
  }

  /** @param now current time, milliseconds. */
  text(done: number, total: number, now: number): string {
    const seconds = (now - this.#start) / 1000
    if (done === 0 || seconds < 1) return ''
    const perSecond = done / seconds
    const rate = perSecond >= 1 ? `${perSecond.toFixed(1)}/s` : `${(60 * perSecond).toFixed(1)}/min`
    return `${rate}, ${duration((total - done) / perSecond)} left`
  }
}

function duration(seconds: number): string {
  if (seconds < 90) return `${Math.ceil(seconds)} s`
  const minutes = Math.ceil(seconds / 60)
  return minutes < 90 ? `${minutes} min` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`
}
