import { Worker } from 'node:worker_threads'
import { OVER_MEMORY, type WatchTask } from './protocol.ts'

/** Milliseconds between two looks: a job allocates some hundred megabytes in that time at most. */
const INTERVAL = 100

/**
 * A thread, since a command that computes answers no timers. What `--max-old-space-size` limits is JavaScript's own heap; pixels
 * and meshes lie outside of it, and count for the operating system.
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

/** Ends this process once it takes too much memory, or the one that started it is gone. */
export function startWatch(task: WatchTask): void {
  new Worker(THREAD, {
    eval: true,
    workerData: { task, interval: INTERVAL, text: OVER_MEMORY },
  }).unref()
}
