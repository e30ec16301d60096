import { readdirSync, readFileSync } from 'node:fs'

/**
 * Interval between samples, milliseconds. A short interval is not needed, because Linux adds the time of an ended
 * process to its parent.
 */
const INTERVAL = 500
/** Number of clock ticks per second in /proc. */
const TICKS = 100

/**
 * Samples the processor time of all processes. Works only on Linux.
 *
 * @returns `seconds(id)` returns the processor time of a process and its descendants, or undefined on other systems.
 *   `sample()` takes a sample now.
 */
export function watchCpuTime() {
  if (process.platform !== 'linux') return { seconds: () => undefined, sample() {} }
  /** Running and ended processes by id. Times are in ticks. `waited` is the time of ended children. */
  const seen = new Map()
  const sample = () => {
    for (const entry of seen.values()) entry.isAlive = false
    for (const id of readdirSync('/proc')) if (/^\d+$/.test(id)) readProcess(Number(id))
  }
  const readProcess = (id) => {
    try {
      // The name of the process is in brackets and may contain spaces.
      const words = readFileSync(`/proc/${id}/stat`, 'utf8').split(') ').at(-1).split(' ').map(Number)
      const [user, system, waitedUser, waitedSystem] = words.slice(11, 15)
      // A process whose parent ends gets another parent. Its time still counts for the first parent.
      const parent = seen.get(id)?.parent ?? words[1]
      seen.set(id, { parent, own: user + system, waited: waitedUser + waitedSystem, isAlive: true })
    } catch {
      // The process has ended.
    }
  }
  const ticksOf = (id) => {
    const { own = 0, waited = 0 } = seen.get(id) ?? {}
    const sums = { ended: 0, running: 0 }
    for (const [child, { parent, isAlive }] of seen) {
      if (parent === id) sums[isAlive ? 'running' : 'ended'] += ticksOf(child)
    }
    return own + Math.max(waited, sums.ended) + sums.running
  }
  setInterval(sample, INTERVAL).unref()
  sample()
  return { seconds: (id) => ticksOf(id) / TICKS, sample }
}
