import { Worker } from 'node:worker_threads'
import { OVER_MEMORY, type WatchTask } from './protocol.ts'

/** Check interval, milliseconds. A job allocates at most some hundred megabytes in that time. */
const INTERVAL = 100

/**
 * Source of the watching thread; timers on the main thread do not fire during a computation. Checks the resident set,
 * because `--max-old-space-size` does not limit typed arrays, such as pixels and meshes.
 */
const THREAD = `
  const { writeSync } = require('node:fs')
  const { workerData } = require('node:worker_threads')
  const { task, interval, text } = workerData
  setInterval(() => {
    const isOrphan = process.ppid !== task.parent
    const isOver = process.memoryUsage.rss() > task.memory
    if (isOver && !isOrphan) writeSync(2, text)
    if (isOver || isOrphan) process.kill(process.pid, 'SIGKILL')
  }, interval)`

/** Kills this process when it exceeds its memory limit, or when its parent has ended. */
export function startWatch(task: WatchTask): void {
  new Worker(THREAD, {
    eval: true,
    workerData: { task, interval: INTERVAL, text: OVER_MEMORY },
  }).unref()
}
