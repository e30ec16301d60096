import { SingleBar } from 'cli-progress'
import type { Progress } from 'furrow-files'
import { escaped } from './print.ts'

/** Runs `work`, synchronous or not, with a progress bar on stderr. The bar is shown only in a terminal. */
export function withBar<T>(name: string, work: (progress: Progress) => T): T {
  const bar = new SingleBar({
    format: `${name} {bar} {step}`,
    stream: process.stderr,
    clearOnComplete: true,
    // By default, the bar turns off line wrapping. If a signal then ended the process, wrapping would stay off.
    linewrap: true,
  })
  let started = false
  let waiting = false
  try {
    const result = work((done, total, step) => {
      const payload = { step: escaped(step ?? `${done}/${total}`) }
      if (!started) bar.start(total, 0, payload)
      started = true
      bar.update(done, payload)
      // Draws the bar at once. During a long synchronous step it would otherwise show the name of the previous step.
      if (step !== undefined && process.stderr.isTTY) bar.render()
    })
    if (!(result instanceof Promise)) return result
    waiting = true
    return result.finally(() => bar.stop()) as T
  } finally {
    if (!waiting) bar.stop()
  }
}
