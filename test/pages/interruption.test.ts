import type { ChildProcess } from 'node:child_process'
import { once } from 'node:events'
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, watch } from 'node:fs'
import { tmpdir } from 'node:os'
import { join, resolve } from 'node:path'
import { performance } from 'node:perf_hooks'
import { setTimeout } from 'node:timers/promises'
import { AUTO_STEPS } from 'furrow/internal'
import { afterAll, beforeAll, describe, expect, it } from 'vitest'
import { startFurrow } from './run-furrow.ts'

/**
 * Number of interruptions per command (default: 4, or 2 if the command starts a browser), and name of the only command to test.
 * `npm run interrupt` sets both.
 */
const { FURROW_MOMENTS, FURROW_COMMAND } = process.env
const MOMENTS = FURROW_MOMENTS === undefined ? undefined : Number(FURROW_MOMENTS)

const SIGNALS = ['SIGINT', 'SIGTERM', 'SIGHUP'] as const

const FACE = resolve('faces/human.glb')
const STROKES = resolve('faces/human/drawn.json')
const root = mkdtempSync(join(tmpdir(), 'interrupted-'))
const pathOf = (name: string) => join(root, name)
const AREAS = ['nose', 'glabella'].map((name) => pathOf(`set/areas/${name}.png`))

/** Arguments of every command that writes files. Outputs go to the folder `new`. */
const COMMANDS: Record<string, string[]> = {
  array: ['array', ...AREAS, '-o', 'new/areas.ktx2'],
  'array --extract': ['array', pathOf('areas.ktx2'), '--extract', 'new/areas'],
  auto: ['auto', FACE, '-o', 'new/face.gltf', '--replace', '--size', '512', '--areas', '3'],
  'auto --report': [
    ...['auto', FACE, '-o', 'new/face.glb', '--replace', '--size', '512', '--areas', '1'],
    ...['--report', 'new/report'],
  ],
  bake: ['bake', FACE, FACE, '-o', 'new/normal.png', '--height', 'new/height.png', '--size', '64'],
  inspect: ['inspect', FACE, '--sheet', 'new/sheet.png'],
  normals: ['normals', AREAS[0]!, '-o', 'new/normal.png', '--strength', '2'],
  pack: ['pack', pathOf('set'), '-o', 'new/face.gltf'],
  render: ['render', FACE, '-o', 'new/picture.png', '--size', '64x64'],
  strokes: ['strokes', STROKES, '--face', FACE, '--areas', 'new/areas', '-o', 'new/h.png', '--size', '256'],
  unpack: ['unpack', FACE, '-o', 'new/set'],
  uv: ['uv', FACE, '-o', 'new/uv.png', '--size', '512'],
}

const chosen = Object.entries(COMMANDS).filter(([name]) => name === (FURROW_COMMAND ?? name))
if (chosen.length === 0) {
  throw new Error(`no command "${FURROW_COMMAND}" writes files, allowed: ${Object.keys(COMMANDS).join(', ')}`)
}

/** Commands that start a browser, which is slow. */
const DRAWING = ['auto --report', 'render']

beforeAll(async () => {
  await expectSuccess(start(root, 'unpack', FACE, '-o', 'set'))
  await expectSuccess(start(root, 'array', ...AREAS, '-o', 'areas.ktx2'))
})

afterAll(() => rmSync(root, { recursive: true, force: true }))

describe.each(chosen)('furrow %s', (name, args) => {
  const moments = MOMENTS ?? (DRAWING.includes(name) ? 2 : 4)

  it(`writes either all outputs or none if interrupted at any of ${moments} moments`, async () => {
    const complete = bench()
    const begin = performance.now()
    await expectSuccess(start(complete, ...args))
    const duration = performance.now() - begin
    const files = filesOf(complete)
    await expectNothingElse(complete)
    for (let moment = 0; moment < moments; moment++) {
      const folder = bench()
      const signal = SIGNALS[moment % SIGNALS.length]
      const child = start(folder, ...args)
      const ended = finish(child)
      const written = watch(join(folder, 'out'), { recursive: true })
      // The last interruption comes when the command begins to write.
      const isLast = moment === moments - 1
      await Promise.race([
        ended,
        isLast ? once(written, 'change') : setTimeout(((moment + 0.5) / moments) * duration),
      ])
      written.close()
      child.kill(signal)
      await expectEnd(await ended, signal, folder, files)
    }
  })
})

/** Steps, in order, that the progress bar of `furrow auto --report` names before the command writes files. */
const STEPS = ['reading', ...AUTO_STEPS, 'encoding', 'report', 'pictures']
/** Option of Node that makes the command draw a progress bar as in a terminal. */
const TERMINAL = '--import=data:text/javascript,process.stderr.isTTY=true'

const hasReport = chosen.some(([name]) => name === 'auto --report')

describe.runIf(hasReport)('furrow auto --report in a terminal', () => {
  it.each(STEPS)('stops when interrupted at the step "%s"', async (step) => {
    const folder = bench()
    const env = { TMPDIR: join(folder, 'tmp'), NODE_OPTIONS: TERMINAL }
    const child = startFurrow(join(folder, 'out'), env, ...COMMANDS['auto --report'])
    const ended = finish(child)
    let shown = ''
    child.stderr!.on('data', (data) => {
      const isSent = shown.includes(` ${step}`)
      shown += data
      if (!isSent && shown.includes(` ${step}`)) child.kill('SIGINT')
    })
    expect(await ended, shown).toEqual({ code: null, signal: 'SIGINT' })
    expect(shown).toContain(` ${step}`)
    expect(filesOf(folder)).toEqual([])
    await expectNothingElse(folder)
  })
})

interface End {
  code: number | null
  signal: NodeJS.Signals | null
}

/** Creates a folder for a run of a command, with subfolders: `out` for its outputs, `tmp` for its temporary files. */
function bench(): string {
  const folder = mkdtempSync(join(root, 'bench-'))
  for (const name of ['out', 'tmp']) mkdirSync(join(folder, name))
  return folder
}

function start(folder: string, ...args: string[]): ChildProcess {
  const isBench = existsSync(join(folder, 'out'))
  return startFurrow(
    isBench ? join(folder, 'out') : folder,
    isBench ? { TMPDIR: join(folder, 'tmp') } : {},
    ...args,
  )
}

async function finish(child: ChildProcess): Promise<End> {
  const [code, signal] = await once(child, 'close')
  return { code, signal }
}

async function expectSuccess(child: ChildProcess): Promise<void> {
  let errors = ''
  child.stderr!.on('data', (data) => {
    errors += data
  })
  expect(await finish(child), errors).toEqual({ code: 0, signal: null })
}

/** Expects that the signal ended the command with all outputs or with none, or that the command succeeded with all outputs. */
async function expectEnd({ code, signal }: End, sent: NodeJS.Signals, folder: string, complete: string[]) {
  if (signal === null) expect(code).toBe(0)
  else expect(signal).toBe(sent)
  const files = filesOf(folder)
  if (signal === null || files.length > 0) expect(files).toEqual(complete)
  await expectNothingElse(folder)
}

async function expectNothingElse(folder: string): Promise<void> {
  expect(readdirSync(join(folder, 'tmp'))).toEqual([])
  // A killed process ends with a delay.
  await expect.poll(() => processesWith(folder), { timeout: 60_000 }).toEqual([])
}

function filesOf(folder: string): string[] {
  return readdirSync(join(folder, 'out'), { recursive: true }).map(String).sort()
}

/** Returns the command lines that name a folder, for example the command line of a browser whose profile is in the folder. */
function processesWith(folder: string): string[] {
  if (process.platform !== 'linux') return []
  return readdirSync('/proc').flatMap((id) => {
    if (!/^\d+$/.test(id)) return []
    try {
      const command = readFileSync(`/proc/${id}/cmdline`, 'utf8')
      return command.includes(folder) ? [command] : []
    } catch {
      return []
    }
  })
}
