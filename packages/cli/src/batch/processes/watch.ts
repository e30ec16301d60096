import { Worker } from 'node:worker_threads'
import { OVER_MEMORY, type WatchTask } from './protocol.ts'

/** Interval between checks, milliseconds. A job allocates at most a few hundred megabytes in this time. */
const INTERVAL = 100

/**
 * Source code of the watching thread. A thread is needed, because timers on the main thread wait for running
 * computations. The thread checks the resident memory, because `--max-old-space-size` does not limit typed arrays, such
 * as pixels and meshes.
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

/**
 * Watches this process from a thread. Kills the process when it exceeds its memory limit, or when its parent has ended.
 */
export function startWatch(task: WatchTask): void {
  new Worker(THREAD, {
    eval: true,
    workerData: { task, interval: INTERVAL, text: OVER_MEMORY },
  }).unref()
}
