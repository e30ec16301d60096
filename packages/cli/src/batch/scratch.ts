import { spawn } from 'node:child_process'
import { mkdtempSync, rmSync } from 'node:fs'
import type { Socket } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { onInterruption } from '../interruption.ts'

/** A private folder for the files of one run. */
export interface Scratch {
  path: string
  remove(): void
}

/**
 * Removes a folder once the process at the other end of stdin is gone, even by SIGKILL. The second time is for a job whose
 * process ends up to 100 ms later.
 */
const GUARD = `process.stdin.resume().on('close', () => {
  for (const pause of [300, 2000]) {
    setTimeout(() => fs.rmSync(process.argv[1], { recursive: true, force: true, maxRetries: 5 }), pause)
  }
})`

/**
 * Makes a folder that only this user can open, under a name that nobody can guess. It is gone after `remove`, or when this process
 * ends in any way: a process of its own watches over it.
 *
 * @param endsBySignal whether signals end this process; otherwise it has listeners of its own.
 */
export function openScratch({ endsBySignal }: { endsBySignal: boolean }): Scratch {
  let clear = () => {}
  const takeBack = endsBySignal ? onInterruption(() => clear()) : () => {}
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
      takeBack()
    },
  }
}

function guard(path: string): () => void {
  // Detached: signals of a terminal reach all processes of a group.
  const child = spawn(process.execPath, ['-e', GUARD, path], {
    detached: true,
    stdio: ['pipe', 'ignore', 'ignore'],
    windowsHide: true,
  })
  // Where the system has no room for a process, the folder lacks its guard alone.
  child.on('error', () => {})
  child.stdin.on('error', () => {})
  child.unref()
  ;(child.stdin as Socket).unref()
  return () => child.kill('SIGKILL')
}
