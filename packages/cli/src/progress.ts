import { SingleBar } from 'cli-progress'
import type { Progress } from 'furrow-files'
import { escaped } from './print.ts'

/** Runs `work`, synchronous or not, with a progress bar on stderr. Without a terminal, shows nothing. */
export function withBar<T>(name: string, work: (progress: Progress) => T): T {
  const bar = new SingleBar({
    format: `${name} {bar} {step}`,
    stream: process.stderr,
    clearOnComplete: true,
    // The default turns off line wrapping, and a signal would leave the terminal in that state.
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
      // A long synchronous step would otherwise show the name of the previous step.
      if (step !== undefined && process.stderr.isTTY) bar.render()
    })
    if (!(result instanceof Promise)) return result
    waiting = true
    return result.finally(() => bar.stop()) as T
  } finally {
    if (!waiting) bar.stop()
  }
}
