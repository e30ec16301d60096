import { mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import sharp from 'sharp'
import { afterAll, beforeAll, beforeEach, describe, expect, test } from 'vitest'
import { setOf } from '../cases.ts'
import { CHIN, FOREHEAD, largestDifference } from './pixels.ts'
import type { CanvasPixels } from './read-canvas.ts'
import { type CommandResult, runFurrow } from './run-furrow.ts'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
const FACE = join(ROOT, 'faces/human.glb')

let folder: string
let out: string

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'furrow-render-'))
})

beforeEach(async () => {
  out = await mkdtemp(join(folder, 'out-'))
})

afterAll(() => rm(folder, { recursive: true, force: true }))

/** Options of all pictures. Other tests draw relief, which takes seconds to prepare. */
const SMALL = ['--size', '200x152', '--relief', 'off']

describe('furrow render', () => {
  test('shows wrinkles only if they are on', async () => {
    const [file, plain] = [join(out, 'on.png'), join(out, 'off.png')]
    const options = ['--expression', 'surprised', ...SMALL]
    const result = await furrow('render', FACE, '-o', file, ...options, '--json')
    expect(result.stderr).toBe('')
    expect(result.code).toBe(0)
    const report = JSON.parse(result.stdout)
    expect(report).toMatchObject({ file, width: 200, height: 152, renderer: 'WebGL 2' })
    expect(report.adapter).not.toBe('')
    expect(report.milliseconds).toBeGreaterThan(0)
    expect(await readdir(out)).toEqual(['on.png'])
    expect(await furrow('render', FACE, '-o', plain, ...options, '--mode', 'off')).toMatchObject({ code: 0 })
    const [wrinkled, smooth] = [await read(file), await read(plain)]
    expect([wrinkled.width, wrinkled.height]).toEqual([200, 152])
    expect(largestDifference(wrinkled, smooth, FOREHEAD)).toBeGreaterThan(20)
    expect(largestDifference(wrinkled, smooth, CHIN)).toBe(0)
  })

  test("accepts WebGPU, blendshapes, activations, a view and the paper's mode", async () => {
    const file = join(out, 'new', 'folder', 'brow.png')
    const options = ['--renderer', 'webgpu', '--view', 'close', '--mode', 'paper', ...SMALL, '--json']
    const weights = ['--set', 'browOuterUpLeft=1', 'jawOpen=0.2', '--activation', 'foreheadLeft=0.7']
    const result = await furrow('render', FACE, '-o', file, ...options, ...weights)
    expect(result.stderr).toBe('')
    expect(JSON.parse(result.stdout)).toMatchObject({ file, width: 200, height: 152, renderer: 'WebGPU' })
    expect((await read(file)).width).toBe(200)
  })
})

describe('furrow render refuses', () => {
  test('to overwrite an image of its wrinkles', async () => {
    const file = join(out, 'map.png')
    const image = await sharp({ create: { width: 4, height: 4, channels: 3, background: 'gray' } })
      .png()
      .toBuffer()
    await writeFile(file, image)
    await writeFile(join(out, 'wrinkles.json'), JSON.stringify(setOf('map.png')))
    const words = ['--wrinkles', join(out, 'wrinkles.json'), '-o', file, ...SMALL]
    await expectRefusal(
      await furrow('render', FACE, ...words),
      /map\.png is the input; choose another output$/m,
    )
    expect(await readFile(file)).toEqual(image)
  })

  // Checks how the program reports errors. Unit tests check all errors.
  test.each<[string, string[], RegExp]>([
    ['a missing face', ['missing.glb'], /cannot read the face missing\.glb/],
    ['wrinkles of no set', [FACE, '--wrinkles', 'no-set.json'], /no-set\.json: layers must be an array/],
    ['an unknown option', [FACE, '--colour'], /unknown option '--colour'/],
    ['two faces', [FACE, FACE], /too many arguments/],
  ])('%s', async (_, args, message) => {
    await writeFile(join(folder, 'no-set.json'), '{}')
    const before = await listing(folder)
    await expectRefusal(await furrow('render', ...args, '-o', join(out, 'x.png')), message)
    expect(await listing(folder)).toEqual(before)
  })

  test('to run without an output', async () => expectRefusal(await furrow('render', FACE), /-o, --output/))

  test('a truncated image of the set', async () => {
    const png = await sharp({ create: { width: 64, height: 64, channels: 3, background: '#8080ff' } })
      .png()
      .toBuffer()
    await writeFile(join(out, 'cut.png'), png.subarray(0, 60))
    await writeFile(join(out, 'set.json'), JSON.stringify(setOf('cut.png')))
    const args = [FACE, '-o', join(out, 'x.png'), '--wrinkles', join(out, 'set.json')]
    await expectRefusal(await furrow('render', ...args), /cut\.png: not a readable image/)
    expect((await readdir(out)).sort()).toEqual(['cut.png', 'set.json'])
  })

  test('an unknown mesh', async () => {
    const args = [FACE, '-o', join(out, 'x.png'), '--mesh', 'hat']
    await expectRefusal(await furrow('render', ...args), /"hat", allowed: .*skin/)
  })

  test('a missing browser', async () => {
    const args = ['render', FACE, '-o', join(out, 'x.png')]
    await expectRefusal(await furrowWith({ FURROW_CHROMIUM: '/missing/chrome' }, ...args), /FURROW_CHROMIUM/)
  })
})

function furrow(...args: string[]): Promise<CommandResult> {
  return furrowWith({}, ...args)
}

function furrowWith(env: NodeJS.ProcessEnv, ...args: string[]): Promise<CommandResult> {
  return runFurrow(folder, env, ...args)
}

/** Expects one line on stderr, nothing on stdout, and exit code 1. */
function expectRefusal({ code, stdout, stderr }: CommandResult, message: RegExp): void {
  expect(stderr).toMatch(message)
  expect(stderr.trimEnd().split('\n')).toHaveLength(1)
  expect(stdout).toBe('')
  expect(code).toBe(1)
}

/** Lists all files in a folder and its subfolders. */
async function listing(path: string): Promise<string[]> {
  return (await readdir(path, { recursive: true })).sort()
}

async function read(file: string): Promise<CanvasPixels> {
  const { data, info } = await sharp(file).removeAlpha().raw().toBuffer({ resolveWithObject: true })
  return { width: info.width, height: info.height, data }
}
