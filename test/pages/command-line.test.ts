import { spawn } from 'node:child_process'
import { once } from 'node:events'
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join, resolve } from 'node:path'
import { afterAll, describe, expect, it } from 'vitest'
import { BIN, runFurrow, startFurrow } from './run-furrow.ts'

const folder = mkdtempSync(join(tmpdir(), 'furrow-line-'))
const FACE = resolve('faces/human.glb')
const run = (...args: string[]) => runFurrow(folder, {}, ...args)

afterAll(() => rmSync(folder, { recursive: true }))

describe('the command line', () => {
  it('prints the help without arguments', async () => {
    const { code, stdout, stderr } = await run()
    expect({ code, stderr }).toEqual({ code: 0, stderr: '' })
    expect(stdout).toBe((await run('--help')).stdout)
  })

  it.each([['help'], ['help', 'help']])('%s %s prints the help', async (...args) => {
    expect(await run(...args)).toEqual(await run('--help'))
  })

  it('--help auto prints the help of auto', async () => {
    expect(await run('--help', 'auto')).toEqual(await run('auto', '--help'))
  })

  it('prints its version', async () => {
    const { version } = JSON.parse(readFileSync('packages/cli/package.json', 'utf8'))
    expect(await run('--version')).toEqual({ code: 0, stdout: `${version}\n`, stderr: '' })
  })

  it('prints help with examples', async () => {
    const { code, stdout } = await run('--help')
    expect(code).toBe(0)
    expect(stdout).toContain('Examples:')
    expect((await run('render', '--help')).stdout).toContain('--expression surprised')
  })

  it.each([['--help'], ['help'], ['auto', '--help'], ['help', 'auto'], ['--version']])(
    '%s %s succeeds',
    async (...args) => {
      expect(await run(...args)).toMatchObject({ code: 0, stderr: '' })
    },
  )

  it.each<[string[], string]>([
    [['atuo'], 'furrow: unknown command \'atuo\'; did you mean "auto"?'],
    [['wrinkle'], "furrow: unknown command 'wrinkle'.*"],
    [['help', 'atuo'], 'furrow: unknown command \'atuo\'; did you mean "auto"?'],
    [['help', 'bogus'], "furrow: unknown command 'bogus'; see furrow --help"],
    [['bogus', '--help'], "furrow: unknown command 'bogus'; see furrow --help"],
    [['auto'], "furrow auto: required option '-o, --output <file>' not specified; see furrow auto --help"],
    [['auto', 'a', 'b', '-o', 'x.glb'], 'furrow auto: too many arguments .*; see furrow auto --help'],
    [
      ['inspect', 'none.glb'],
      'furrow inspect: cannot read the face none.glb .it does not exist.; check the path',
    ],
    [['inspect', 'a\x1b[31m.glb'], 'furrow inspect: cannot read the face a\\\\u001b\\[31m.glb .*'],
  ])('%j fails with exit code 1 and one line', async (args, line) => {
    const { code, stdout, stderr } = await run(...args)
    expect({ code, stdout }).toEqual({ code: 1, stdout: '' })
    expect(stderr).toMatch(new RegExp(`^${line.replaceAll('?', '\\?')}\n$`))
  })

  it('writes a file to stdout, and messages to stderr', async () => {
    const child = startFurrow(folder, {}, 'inspect', FACE, '--sheet', '-')
    const chunks: Buffer[] = []
    let stderr = ''
    child.stdout.on('data', (data) => chunks.push(data))
    child.stderr.on('data', (data) => {
      stderr += data
    })
    expect(await once(child, 'close')).toEqual([0, null])
    expect(Buffer.concat(chunks).toString('latin1', 0, 8)).toBe('\x89PNG\r\n\x1a\n')
    expect(stderr).toContain('wrinkles on material')
    expect(readdirSync(folder)).toEqual([])
  })

  it.each([
    ['text', 'inspect'],
    ['a file', 'inspect --sheet -'],
  ])('ends quietly when its reader closes the pipe: %s', async (_, args) => {
    const shell = spawn(
      'sh',
      ['-c', `"$0" "$1" ${args} "$2" | head -c 1 > /dev/null`, process.execPath, BIN, FACE],
      {
        stdio: ['ignore', 'ignore', 'pipe'],
      },
    )
    let stderr = ''
    shell.stderr.on('data', (data) => {
      stderr += data
    })
    expect(await once(shell, 'close')).toEqual([0, null])
    expect(args.includes('--sheet') || stderr === '').toBe(true)
    expect(stderr).not.toContain('Error')
  })

  it('reads a face from a pipe', async () => {
    const shell = spawn(
      'sh',
      ['-c', 'cat "$2" | "$0" "$1" inspect /dev/stdin', process.execPath, BIN, FACE],
      {
        stdio: ['ignore', 'pipe', 'inherit'],
      },
    )
    let stdout = ''
    shell.stdout.on('data', (data) => {
      stdout += data
    })
    await once(shell, 'close')
    expect(stdout).toContain('wrinkles on material')
  })
})
