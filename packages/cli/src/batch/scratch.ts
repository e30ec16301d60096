import { spawn } from 'node:child_process'
import { mkdtempSync, rmSync } from 'node:fs'
import type { Socket } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { onInterruption } from '../interruption.ts'

/** Private folder for the files of one run. */
export interface Scratch {
  path: string
  remove(): void
}

/**
 * Source of the guard process: removes a folder when the process at the other end of stdin has ended, even by SIGKILL.
 * Removes it twice, because a job's process may end up to 100 ms later.
 */
const GUARD = `process.stdin.resume().on('close', () => {
  for (const pause of [300, 2000]) {
    setTimeout(() => fs.rmSync(process.argv[1], { recursive: true, force: true, maxRetries: 5 }), pause)
  }
})`

/**
 * Creates a folder with a random name that only this user can open. `remove` deletes the folder. If this process ends
 * in any other way, a guard process deletes it.
 *
 * @param endsBySignal whether signals end this process; false if the caller handles them.
 */
export function openScratch({ endsBySignal }: { endsBySignal: boolean }): Scratch {
  let clear = () => {}
  const unregister = endsBySignal ? onInterruption(() => clear()) : () => {}
  const path = mkdtempSync(join(tmpdir(), 'furrow-'))
  const release = guard(path)
  clear = () => {
    rmSync(path, { recursive: true, force: true, maxRetries: 5 })
    release()
  }
  return {
    path,
    remove() {
      clear()
      unregister()
    },
  }
}

function guard(path: string): () => void {
  // Detached: terminal signals reach all processes of a group.
  const child = spawn(process.execPath, ['-e', GUARD, path], {
    detached: true,
    stdio: ['pipe', 'ignore', 'ignore'],
    windowsHide: true,
  })
  // If the process cannot be started, the folder has no guard.
  child.on('error', () => {})
  child.stdin.on('error', () => {})
  child.unref()
  ;(child.stdin as Socket).unref()
  return () => child.kill('SIGKILL')
}
