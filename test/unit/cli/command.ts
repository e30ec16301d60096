import { existsSync, mkdtempSync, readdirSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import type { Command } from 'commander'
import { afterAll, beforeEach, expect, vi } from 'vitest'

/** A folder of its own for the tests of one command, and what the command prints. */
export function bench(command: Command) {
  const folder = mkdtempSync(join(tmpdir(), `furrow-${command.name()}-`))
  const file = (name: string) => join(folder, name)
  const bench = { folder, file, printed: '', warned: '', run, fails }
  beforeEach(() => {
    bench.printed = ''
    bench.warned = ''
    vi.spyOn(process.stdout, 'write').mockImplementation((text) => {
      bench.printed += text
      return true
    })
    vi.spyOn(console, 'error').mockImplementation((text) => {
      bench.warned += `${text}\n`
    })
  })
  afterAll(() => {
    vi.restoreAllMocks()
    rmSync(folder, { recursive: true })
  })

  function run(...args: string[]) {
    return command.parseAsync(args, { from: 'user' })
  }

  /** Expects one clear line that has `message` in it, or matches it, and no file more or less than before. */
  async function fails(message: string | RegExp, ...args: string[]) {
    const before = readdirSync(folder, { recursive: true }).sort()
    const failure = await run(...args).then(
      () => undefined,
      (error: Error) => error,
    )
    expect(failure?.message ?? '(nothing thrown)').toMatch(message)
    expect(failure?.name).toBe('FurrowError')
    expect(failure?.message).toMatch(new RegExp(`^furrow ${command.name()}: [^\\n]*; [^\\n]*$`))
    expect(existsSync(file('x.png'))).toBe(false)
    expect(readdirSync(folder, { recursive: true }).sort()).toEqual(before)
  }
  return bench
}
