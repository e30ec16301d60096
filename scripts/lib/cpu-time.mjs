import { readdirSync, readFileSync } from 'node:fs'

/** How often processes are looked at, in milliseconds. What one does after the last look is counted where its parent waits for it. */
const EVERY = 500
/** Units of processor time in a second, as Linux tells programs. */
const TICKS = 100

/**
 * Watches the processor time of all processes, as Linux counts it.
 *
 * @returns `seconds`, of a process and all that it started so far, undefined on other systems; and `look`, to count what happened
 *   since the last look.
 */
export function watchCpuTime() {
  if (process.platform !== 'linux') return { seconds: () => undefined, look() {} }
  /** By process id, ended ones included. Times are in ticks; `waited` is that of ended children which it waited for. */
  const seen = new Map()
  const look = () => {
    for (const entry of seen.values()) entry.isAlive = false
    for (const id of readdirSync('/proc')) if (/^\d+$/.test(id)) lookAt(Number(id))
  }
  const lookAt = (id) => {
    try {
      // The name before it is in brackets and may have spaces.
      const words = readFileSync(`/proc/${id}/stat`, 'utf8').split(') ').at(-1).split(' ').map(Number)
      const [user, system, waitedUser, waitedSystem] = words.slice(11, 15)
      // A process whose parent has ended still belongs to it.
      const parent = seen.get(id)?.parent ?? words[1]
      seen.set(id, { parent, own: user + system, waited: waitedUser + waitedSystem, isAlive: true })
    } catch {
      // It ended meanwhile.
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
  // It keeps no process alive.
  setInterval(look, EVERY).unref()
  look()
  return { seconds: (id) => ticksOf(id) / TICKS, look }
}
