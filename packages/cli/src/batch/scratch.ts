import { spawn } from 'node:child_process'
import { mkdtempSync, rmSync } from 'node:fs'
import type { Socket } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { onInterruption } from '../interruption.ts'

/** Private temporary folder of a batch or a worker. */
export interface Scratch {
  path: string
  remove(): void
}

/**
 * Source code of the guard process. Its stdin closes when the parent process ends, even by SIGKILL. The guard then
 * removes a folder. It does so twice, because a job's process can outlive the parent by 100 ms and write more files.
 */
const GUARD = `process.stdin.resume().on('close', () => {
  for (const pause of [300, 2000]) {
    setTimeout(() => fs.rmSync(process.argv[1], { recursive: true, force: true, maxRetries: 5 }), pause)
  }
})`

/**
 * Creates a folder with a random name. Only this user can open the folder. `remove` deletes it. If this process ends
 * before `remove` is called, a guard process deletes it.
 *
 * @param endsBySignal whether signals end this process. False if the caller handles signals.
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
  // The terminal sends signals to its whole process group. A detached process is in another group.
  const child = spawn(process.execPath, ['-e', GUARD, path], {
    detached: true,
    stdio: ['pipe', 'ignore', 'ignore'],
    windowsHide: true,
  })
  // If the guard cannot be started, the run continues without it.
  child.on('error', () => {})
  child.stdin.on('error', () => {})
  child.unref()
  ;(child.stdin as Socket).unref()
  return () => child.kill('SIGKILL')
}
