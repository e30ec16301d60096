import type { ResultLine } from './results.ts'

/** How many of what, for people and programs. */
export interface BatchCounts {
  inputs: number
  /** All that have a result now. */
  done: number
  failed: number
  warned: number
  /** Of those done: known from an earlier run, and sharing another one's job. */
  kept: number
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
    shared > 0 && `${shared} the same as others`,
    kept > 0 && `${kept} known from before`,
  ]
  return parts.filter((part) => part !== false).join(', ')
}

/** Measures how fast jobs end, for the bar. */
export class Rate {
  readonly #start: number

  constructor(now: number) {
    this.#start = now
  }

  /** @param now in milliseconds. */
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
