import { readdirSync, readFileSync } from 'node:fs'

/** Sampling interval, milliseconds. Linux adds a process's remaining time to its parent when it exits. */
const INTERVAL = 500
/** Clock ticks per second of /proc on Linux. */
const TICKS = 100

/**
 * Samples the processor time of all processes. Only Linux is supported.
 *
 * @returns `seconds(id)`: processor time of a process and its descendants, undefined on other systems; `sample()`: updates now.
 */
export function watchCpuTime() {
  if (process.platform !== 'linux') return { seconds: () => undefined, sample() {} }
  /** Running and ended processes by id. Times in ticks; `waited` is the time of ended children. */
  const seen = new Map()
  const sample = () => {
    for (const entry of seen.values()) entry.isAlive = false
    for (const id of readdirSync('/proc')) if (/^\d+$/.test(id)) readProcess(Number(id))
  }
  const readProcess = (id) => {
    try {
      // The process name is in brackets and may have spaces.
      const words = readFileSync(`/proc/${id}/stat`, 'utf8').split(') ').at(-1).split(' ').map(Number)
      const [user, system, waitedUser, waitedSystem] = words.slice(11, 15)
      // Orphans stay with their first parent.
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
