import { mkdtempSync, rmSync } from 'node:fs'
import { rm } from 'node:fs/promises'
import { constants, tmpdir } from 'node:os'
import { join } from 'node:path'
import { setImmediate } from 'node:timers/promises'

const SIGNALS = ['SIGHUP', 'SIGINT', 'SIGTERM'] as const

const cleanUps = new Set<() => void>()

/**
 * Runs `cleanUp` if a signal ends the process. Signal listeners exist only while a clean-up is registered. Without
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

/** Runs synchronous work without interruption: a signal that arrives meanwhile ends the process afterwards. */
export async function uninterrupted<T>(work: () => T): Promise<T> {
  const unregister = onInterruption(() => {})
  try {
    return work()
  } finally {
    await setImmediate()
    unregister()
  }
}

/** Creates a folder for temporary files. `remove`, or a signal that ends the process, deletes it. */
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
      // A browser that was just closed may still write files.
      await rm(made, { recursive: true, force: true, maxRetries: 5 }).catch(() => {})
      unregister()
    },
  }
}

/** Exits like the signal's default action: a shell sees 130 for SIGINT, 143 for SIGTERM, and stops its loop. */
function interrupt(signal: NodeJS.Signals): void {
  // Runs after other listeners: Playwright kills the browser, which keeps its profile in a temporary folder.
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
