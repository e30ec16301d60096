import { mkdtempSync, rmSync } from 'node:fs'
import { rm } from 'node:fs/promises'
import { constants, tmpdir } from 'node:os'
import { join } from 'node:path'
import { setImmediate } from 'node:timers/promises'

const SIGNALS = ['SIGHUP', 'SIGINT', 'SIGTERM'] as const

const cleanUps = new Set<() => void>()

/**
 * Runs `cleanUp` if a signal ends the process. Signals are listened to only while there is something to clean up:
 * otherwise they end the process at once, even during a long computation, in which no listener would be called.
 *
 * @param cleanUp synchronous.
 * @returns a function that takes it back.
 */
export function onInterruption(cleanUp: () => void): () => void {
  if (cleanUps.size === 0) for (const signal of SIGNALS) process.on(signal, interrupt)
  cleanUps.add(cleanUp)
  return () => {
    cleanUps.delete(cleanUp)
    if (cleanUps.size === 0) stopListening()
  }
}

/** Runs synchronous work that no signal interrupts: one that arrives meanwhile ends the process afterwards. */
export async function uninterrupted<T>(work: () => T): Promise<T> {
  const takeBack = onInterruption(() => {})
  try {
    return work()
  } finally {
    await setImmediate()
    takeBack()
  }
}

/** A new folder for temporary files; it is gone once it is removed, or a signal has ended the process. */
export function temporaryFolder(): { path: string; remove: () => Promise<void> } {
  let path: string | undefined
  const takeBack = onInterruption(() => {
    if (path) rmSync(path, { recursive: true, force: true, maxRetries: 5 })
  })
  const made = mkdtempSync(join(tmpdir(), 'furrow-'))
  path = made
  return {
    path,
    async remove() {
      // What a browser that has just been closed still writes must not become the user's problem.
      await rm(made, { recursive: true, force: true, maxRetries: 5 }).catch(() => {})
      takeBack()
    },
  }
}

/** Ends as the signal would have: a shell sees 130 for SIGINT, 143 for SIGTERM, and stops its loop. */
function interrupt(signal: NodeJS.Signals): void {
  // After the listeners of others: Playwright's kills the browser, whose profile is in a temporary folder.
  process.once('exit', () => {
    for (const cleanUp of cleanUps) cleanUp()
    stopListening()
    if (process.platform !== 'win32') process.kill(process.pid, signal)
  })
  process.exit(128 + constants.signals[signal])
}

function stopListening(): void {
  for (const signal of SIGNALS) process.off(signal, interrupt)
}
