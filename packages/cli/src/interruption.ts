import { mkdtempSync, rmSync } from 'node:fs'
import { rm } from 'node:fs/promises'
import { constants, tmpdir } from 'node:os'
import { join } from 'node:path'
import { setImmediate } from 'node:timers/promises'

const SIGNALS = ['SIGHUP', 'SIGINT', 'SIGTERM'] as const

const cleanUps = new Set<() => void>()

/**
 * Calls `cleanUp` if a signal ends the process. Listens to signals only while a `cleanUp` is registered: without
 * listeners, a signal ends the process at once, even during a long computation.
 *
 * @param cleanUp synchronous function.
 * @returns a function that unregisters `cleanUp`.
 */
export function onInterruption(cleanUp: () => void): () => void {
  if (cleanUps.size === 0) for (const signal of SIGNALS) process.on(signal, interrupt)
  cleanUps.add(cleanUp)
  return () => {
    cleanUps.delete(cleanUp)
    if (cleanUps.size === 0) stopListening()
  }
}

/**
 * Runs synchronous work that signals do not interrupt. A signal that arrives during the work ends the process
 * afterwards.
 */
export async function uninterrupted<T>(work: () => T): Promise<T> {
  const unregister = onInterruption(() => {})
  try {
    return work()
  } finally {
    await setImmediate()
    unregister()
  }
}

/** Creates a folder for temporary files. The folder is deleted by `remove`, or by a signal that ends the process. */
export function temporaryFolder(): { path: string; remove: () => Promise<void> } {
  let path: string | undefined
  const unregister = onInterruption(() => {
    if (path) rmSync(path, { recursive: true, force: true, maxRetries: 5 })
  })
  const made = mkdtempSync(join(tmpdir(), 'furrow-'))
  path = made
  return {
    path,
    async remove() {
      // A browser may still write files shortly after it was closed.
      await rm(made, { recursive: true, force: true, maxRetries: 5 }).catch(() => {})
      unregister()
    },
  }
}

/**
 * Ends the process as the signal's default action would. So a shell script that runs the command in a loop sees the
 * status 130 (SIGINT) or 143 (SIGTERM), and stops.
 */
function interrupt(signal: NodeJS.Signals): void {
  // The clean-ups run after Playwright's listener, which kills the browser. A running browser would write more
  // temporary files.
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
