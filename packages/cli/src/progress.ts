import { SingleBar } from 'cli-progress'

/** Told now and then how much of a long work is done. */
export type Progress = (done: number, total: number) => void

/** Runs `work`, which may be asynchronous, under a bar on stderr; without a terminal there is no bar. */
export function withBar<T>(name: string, work: (progress: Progress) => T): T {
  const bar = new SingleBar({
    format: `${name} {bar} {value}/{total}`,
    stream: process.stderr,
    clearOnComplete: true,
  })
  let started = false
  let waiting = false
  try {
    const result = work((done, total) => {
      if (!started) bar.start(total, 0)
      started = true
      bar.update(done)
    })
    if (!(result instanceof Promise)) return result
    waiting = true
    return result.finally(() => bar.stop()) as T
  } finally {
    if (!waiting) bar.stop()
  }
}
