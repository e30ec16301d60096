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

/** Number of interruptions per command; few by default, because some commands are slow. `npm run interrupt` sets both. */
const { FURROW_MOMENTS, FURROW_COMMAND } = process.env
const MOMENTS = FURROW_MOMENTS === undefined ? undefined : Number(FURROW_MOMENTS)

const SIGNALS = ['SIGINT', 'SIGTERM', 'SIGHUP'] as const

const FACE = resolve('faces/human.glb')
const STROKES = resolve('faces/human/drawn.json')
const root = mkdtempSync(join(tmpdir(), 'interrupted-'))
const pathOf = (name: string) => join(root, name)
const AREAS = ['nose', 'glabella'].map((name) => pathOf(`set/areas/${name}.png`))

/** Every command that writes, with its arguments. Outputs go to the folder `new`. */
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
  throw new Error(`no command "${FURROW_COMMAND}" writes, allowed: ${Object.keys(COMMANDS).join(', ')}`)
}

/** Commands that draw are slow. */
const DRAWING = ['auto --report', 'render']

beforeAll(async () => {
  await expectSuccess(start(root, 'unpack', FACE, '-o', 'set'))
  await expectSuccess(start(root, 'array', ...AREAS, '-o', 'areas.ktx2'))
})

afterAll(() => rmSync(root, { recursive: true, force: true }))

describe.each(chosen)('furrow %s', (name, args) => {
  const moments = MOMENTS ?? (DRAWING.includes(name) ? 2 : 4)

  it(`leaves all or nothing behind when interrupted at ${moments} moments`, async () => {
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
      // The last moment is when the command begins to write.
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

/** Steps shown by the bar of `furrow auto --report` before it writes, in order. */
const STEPS = ['reading', ...AUTO_STEPS, 'encoding', 'report', 'pictures']
/** Makes the command draw its progress bar, as in a terminal. */
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

/** Creates a folder to run a command in. Outputs go to `out`, temporary files to `tmp`. */
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

/** Expects all outputs or none, and an exit by the signal. Shells report 128 + the signal's number. */
async function expectEnd({ code, signal }: End, sent: NodeJS.Signals, folder: string, complete: string[]) {
  if (signal === null) expect(code).toBe(0)
  else expect(signal).toBe(sent)
  const files = filesOf(folder)
  if (signal === null || files.length > 0) expect(files).toEqual(complete)
  await expectNothingElse(folder)
}

async function expectNothingElse(folder: string): Promise<void> {
  expect(readdirSync(join(folder, 'tmp'))).toEqual([])
  // Killed processes take a moment to end.
  await expect.poll(() => processesWith(folder), { timeout: 60_000 }).toEqual([])
}

function filesOf(folder: string): string[] {
  return readdirSync(join(folder, 'out'), { recursive: true }).map(String).sort()
}

/** Returns command lines of processes that work in a folder, such as a browser with its profile there. */
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
