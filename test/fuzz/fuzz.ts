import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { FurrowError } from 'furrow'
import { withBar } from '../../packages/cli/src/progress.ts'
import { writeBases } from './bases.ts'
import { COMMANDS } from './cases.ts'
import type { Outcome } from './child.ts'
import { FINE, type FileLimits, type Tried, tryFiles } from './pool.ts'

export interface FuzzOptions {
  /** Path of the bundled child.ts. */
  child: string
  commands?: readonly string[]
  seed: number
  /** Index of the first file. A file depends only on command, seed and index. */
  first?: number
  /** Number of files per command. */
  count: number
  limits: FileLimits
  jobs: number
  /** Folder that receives the files with unexpected outcomes. */
  keep: string
  report?: (text: string) => void
  /** Ends the run early. The results so far are returned. */
  stop?: AbortSignal
}

export interface CommandResults {
  command: string
  tried: Tried[]
  failures: Tried[]
}

/**
 * Runs commands on damaged files.
 *
 * @throws FurrowError for a command that is not in `COMMANDS`.
 */
export async function fuzz(options: FuzzOptions): Promise<CommandResults[]> {
  const { commands = COMMANDS, first = 0, report = () => {}, stop = new AbortController().signal } = options
  checkCommands(commands)
  const root = mkdtempSync(join(tmpdir(), 'furrow-fuzz-'))
  try {
    const bases = join(root, 'bases')
    await writeBases(bases)
    const folders = { child: options.child, bases, work: root, keep: options.keep }
    const results: CommandResults[] = []
    for (const command of commands) {
      if (stop.aborted) break
      const tried = await withBar(`fuzz ${command}`, (progress) => {
        let [done, failed] = [0, 0]
        const count = ({ outcome }: Tried) => {
          if (!FINE.includes(outcome)) failed++
          progress(++done, options.count, `${done}/${options.count}, failed: ${failed}`)
        }
        return tryFiles(folders, { ...options, command, first }, options.limits, options.jobs, count, stop)
      })
      const failures = tried.filter(({ outcome }) => !FINE.includes(outcome))
      for (const failure of failures) report(failureText(command, failure))
      if (tried.length > 0) report(summaryText(command, tried))
      results.push({ command, tried, failures })
    }
    return results
  } finally {
    rmSync(root, { recursive: true, force: true })
  }
}

function checkCommands(commands: readonly string[]): void {
  const value = commands.find((command) => !COMMANDS.includes(command))
  if (value === undefined) return
  throw new FurrowError({
    code: 'unknown-name',
    who: 'fuzz',
    problem: 'no command of that name reads files',
    value,
    limit: COMMANDS.join(', '),
    remedy: 'name one of these',
  })
}

function failureText(command: string, { index, outcome, message, milliseconds }: Tried): string {
  return `  ${command} ${index}: ${outcome} after ${(milliseconds / 1000).toFixed(1)} s: ${message}`
}

/** Returns a summary of the outcomes, with the slowest run and the one with the highest peak memory. */
function summaryText(command: string, tried: readonly Tried[]): string {
  const counts = new Map<Outcome, number>()
  for (const { outcome } of tried) counts.set(outcome, (counts.get(outcome) ?? 0) + 1)
  const most = (key: 'milliseconds' | 'peak') => tried.reduce((a, b) => (a[key] > b[key] ? a : b))
  const [slowest, largest] = [most('milliseconds'), most('peak')]
  return [
    `${command}: ${[...counts].map(([outcome, count]) => `${count} ${outcome}`).join(', ')}`,
    `slowest ${slowest.index} (${(slowest.milliseconds / 1000).toFixed(1)} s)`,
    `largest ${largest.index} (${Math.round(largest.peak / 2 ** 20)} MB)`,
  ].join('; ')
}
