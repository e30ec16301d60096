import { mkdir, mkdtemp, readdir, readFile, rm, truncate, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { draco } from '@gltf-transform/functions'
import sharp from 'sharp'
import { afterAll, beforeAll, beforeEach, describe, expect, test } from 'vitest'
import { transformFile } from '../../scripts/lib/transform.mjs'
import { editGlb } from '../glb.ts'
import { largestDifference, type Region } from './pixels.ts'
import type { CanvasPixels } from './read-canvas.ts'
import { type Ended, runFurrow } from './run-furrow.ts'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
const FACE = join(ROOT, 'faces/human.glb')

/** The forehead from the front, and what wrinkles of the forehead never reach. */
const FOREHEAD: Region = { left: 0.42, top: 0.18, right: 0.58, bottom: 0.34 }
const CHIN: Region = { left: 0.42, top: 0.62, right: 0.58, bottom: 0.74 }

let folder: string
let out: string

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'furrow-render-'))
})

beforeEach(async () => {
  out = await mkdtemp(join(folder, 'out-'))
})

afterAll(() => rm(folder, { recursive: true, force: true }))

describe('furrow render', () => {
  test.each([
    ['webgl', 'WebGL 2'],
    ['webgpu', 'WebGPU'],
  ])('shows wrinkles on %s, and none when they are off', async (renderer, api) => {
    const options = ['--expression', 'surprised', '--renderer', renderer, '--size', '400x304']
    const file = join(out, 'on.png')
    const made = await furrow('render', FACE, '-o', file, ...options, '--json')
    expect(made.stderr).toBe('')
    expect(made.code).toBe(0)
    const report = JSON.parse(made.stdout)
    expect(report).toMatchObject({ file, width: 400, height: 304, renderer: api })
    expect(report.adapter).not.toBe('')
    expect(report.milliseconds).toBeGreaterThan(0)
    const off = await furrow('render', FACE, '-o', join(out, 'off.png'), ...options, '--mode', 'off')
    expect(off.code).toBe(0)
    const [wrinkled, smooth] = [await read(file), await read(join(out, 'off.png'))]
    expect([wrinkled.width, wrinkled.height]).toEqual([400, 304])
    expect(largestDifference(wrinkled, smooth, FOREHEAD)).toBeGreaterThan(20)
    expect(largestDifference(wrinkled, smooth, CHIN)).toBe(0)
    expect((await readdir(out)).sort()).toEqual(['off.png', 'on.png'])
  })

  test.each([
    ['webgl', 'KTX 2 arrays', (file: string) => pack(file, '--ktx2')],
    ['webgpu', 'KTX 2 arrays', (file: string) => pack(file, '--ktx2')],
    ['webgl', 'Draco', writeDraco],
  ])('shows on %s a face in %s as one in PNG', async (renderer, _, write) => {
    const options = ['--expression', 'surprised', '--renderer', renderer, '--size', '400x304']
    const [compressed, images] = [join(out, 'compressed.glb'), join(out, 'images.glb')]
    await pack(images)
    await write(compressed)
    const draw = async (face: string, ...mode: string[]) => {
      const made = await furrow('render', face, '-o', `${face}.png`, ...options, ...mode)
      expect(made.stderr).toBe('')
      return read(`${face}.png`)
    }
    const [plain, smooth] = [await draw(images), await draw(images, '--mode', 'off')]
    const difference = largestDifference(await draw(compressed), plain, FOREHEAD)
    expect(difference).toBeLessThan(largestDifference(plain, smooth, FOREHEAD) / 3)
  })

  test('takes blendshapes, activations, a view and the mode of the paper', async () => {
    const file = join(out, 'new', 'folder', 'brow.png')
    const options = ['--view', 'close', '--mode', 'paper', '--size', '160x120']
    const weights = ['--set', 'browOuterUpLeft=1', 'jawOpen=0.2', '--activation', 'foreheadLeft=0.7']
    const made = await furrow('render', FACE, '-o', file, ...options, ...weights)
    expect(made.stderr).toBe('')
    expect(made.stdout).toContain('160 x 120')
    expect((await read(file)).width).toBe(160)
  })

  test('makes a picture larger than one tile without a seam', async () => {
    const large = join(out, 'large.png')
    const small = join(out, 'small.png')
    const options = ['--mode', 'off', '--view', 'front']
    expect((await furrow('render', FACE, '-o', large, '--size', '2112x96', ...options)).code).toBe(0)
    expect((await furrow('render', FACE, '-o', small, '--size', '1056x48', ...options)).code).toBe(0)
    const reduced = await sharp(large).resize(1056, 48, { kernel: 'linear' }).removeAlpha().raw().toBuffer()
    const { data } = await read(small)
    const mean = data.reduce((sum, value, i) => sum + Math.abs(value - reduced[i]), 0) / data.length
    expect(mean).toBeLessThan(1)
  })
})

function pack(file: string, ...options: string[]): Promise<Ended> {
  const wrinkles = join(ROOT, 'faces/human')
  return furrow('pack', wrinkles, '--face', FACE, '--size', '512', '-o', file, ...options)
}

async function writeDraco(file: string): Promise<void> {
  await pack(file)
  await transformFile(file, file, [draco({ quantizePosition: 16 })])
}

describe('furrow render refuses', () => {
  const cases: [string, (file: (name: string) => string) => string[], RegExp][] = [
    ['a missing face', () => ['render', 'missing.glb'], /cannot read the face missing\.glb/],
    ['an empty face', (file) => ['render', file('empty.glb')], /it is empty/],
    ['a text', (file) => ['render', file('text.glb')], /does not begin with "glTF"/],
    ['a face cut off in its header', (file) => ['render', file('short.glb')], /cut off after 10 bytes/],
    ['a face cut off', (file) => ['render', file('cut.glb')], /cut off: 50000 of \d+ bytes/],
    ['glTF 1', (file) => ['render', file('old.glb')], /of version 1/],
    ['a folder', (file) => ['render', file('')], /cannot read the face/],
    [
      'a face without wrinkles',
      (file) => ['render', file('bare.glb')],
      /cannot read the wrinkles .*--wrinkles/,
    ],
    ['wrinkles that are no JSON', (file) => [...face, '--wrinkles', file('text.glb')], /are no JSON/],
    ['wrinkles of no set', (file) => [...face, '--wrinkles', file('no-set.json')], /no-set\.json: .*version/],
    [
      'wrinkles without images',
      (file) => [...face, '--wrinkles', file('lone.json')],
      /cannot read .*layer\.png/,
    ],
    ['wrinkles on the network', (file) => [...face, '--wrinkles', file('far.json')], /not on this computer/],
    ['an unknown expression', () => [...face, '--expression', 'bored'], /unknown expression, got "bored"/],
    ['an unknown blendshape', () => [...face, '--set', 'jawOpenn=1'], /unknown blendshape, got "jawOpenn"/],
    ['an unknown area', () => [...face, '--activation', 'chin=1'], /unknown area, got "chin"/],
    ['an unknown view', () => [...face, '--view', 'top'], /unknown view, got "top"/],
    ['an unknown mode', () => [...face, '--mode', 'on'], /unknown mode, got "on"/],
    ['an unknown renderer', () => [...face, '--renderer', 'metal'], /unknown renderer, got "metal"/],
    ['a weight that is no number', () => [...face, '--set', 'jawOpen=wide'], /no weight, got "jawOpen=wide"/],
    ['a weight without a number', () => [...face, '--set', 'jawOpen='], /no weight/],
    ['a weight without a name', () => [...face, '--set', '=1'], /no weight/],
    ['a weight above 1', () => [...face, '--set', 'jawOpen=1.5'], /no weight, got "jawOpen=1.5"/],
    ['an activation below 0', () => [...face, '--activation', 'nose=-1'], /no weight, got "nose=-1"/],
    ['an activation not a number', () => [...face, '--activation', 'nose=NaN'], /no weight/],
    ['a size of one number', () => [...face, '--size', '800'], /no size of a picture, got "800"/],
    ['a size too small', () => [...face, '--size', '800x15'], /no size of a picture/],
    ['a size too large', () => [...face, '--size', '8193x600'], /16\.\.8192/],
    ['an unknown option', () => [...face, '--colour'], /unknown option '--colour'/],
    ['two faces', () => [...face, FACE], /too many arguments/],
    ['a picture that is no PNG', () => [...face, '-o', 'face.jpg'], /does not end in \.png/],
    ['a picture that is a folder', (file) => [...face, '-o', file('folder.png')], /it is a folder/],
    ['a picture under a file', (file) => [...face, '-o', join(file('text.glb'), 'x.png')], /is not a folder/],
  ]
  const face = ['render', FACE]

  beforeAll(async () => {
    const put = (name: string, content: string | Uint8Array) => writeFile(join(folder, name), content)
    const glb = await readFile(FACE)
    const old = Buffer.from(glb)
    old.writeUInt32LE(1, 4)
    await put('empty.glb', '')
    await put('text.glb', 'This is no face, but it is longer than a header.')
    await put('short.glb', glb.subarray(0, 10))
    await put('cut.glb', glb)
    await truncate(join(folder, 'cut.glb'), 50_000)
    await put('old.glb', old)
    const strip = ({ materials }: { materials: { extensions?: object }[] }) => {
      for (const material of materials) delete material.extensions
    }
    await put('bare.glb', editGlb(glb, strip))
    await put('no-set.json', '{}')
    await put('lone.json', JSON.stringify(setWith('layer.png')))
    await put('far.json', JSON.stringify(setWith('https://example.org/layer.png')))
    await mkdir(join(folder, 'folder.png'))
  })

  test.each(cases)('%s', async (_, words, message) => {
    const before = await listing(folder)
    const asked = words((name) => join(folder, name))
    const output = asked.includes('-o') ? [] : ['-o', join(out, 'x.png')]
    // No option of the command follows, so that a list of weights ends where it should.
    await expectRefusal(await furrow(...asked, ...output), message)
    expect(await listing(folder)).toEqual(before)
  })

  test('a missing output', async () => expectRefusal(await furrow('render', FACE), /-o, --output/))

  test('an image of the set that is cut off', async () => {
    const png = await sharp({ create: { width: 64, height: 64, channels: 3, background: '#8080ff' } })
      .png()
      .toBuffer()
    await writeFile(join(out, 'cut.png'), png.subarray(0, 60))
    await writeFile(join(out, 'set.json'), JSON.stringify(setWith('cut.png')))
    const words = [FACE, '-o', join(out, 'x.png'), '--wrinkles', join(out, 'set.json')]
    await expectRefusal(await furrow('render', ...words), /cut\.png: not a readable image/)
    expect((await readdir(out)).sort()).toEqual(['cut.png', 'set.json'])
  })

  test('a mesh that is not there', async () => {
    const words = [FACE, '-o', join(out, 'x.png'), '--mesh', 'hat']
    await expectRefusal(await furrow('render', ...words), /"hat", allowed: .*skin/)
  })

  test('a browser that is not there', async () => {
    const words = ['render', FACE, '-o', join(out, 'x.png')]
    await expectRefusal(await furrowWith({ FURROW_CHROMIUM: '/missing/chrome' }, ...words), /FURROW_CHROMIUM/)
  })
})

describe('furrow', () => {
  test('tells its version', async () => {
    const { version } = JSON.parse(await readFile(join(ROOT, 'packages/cli/package.json'), 'utf8'))
    expect(await furrow('--version')).toEqual({ code: 0, stdout: `${version}\n`, stderr: '' })
  })

  test('helps with examples', async () => {
    const { code, stdout } = await furrow('--help')
    expect(code).toBe(0)
    expect(stdout).toContain('Examples:')
    expect((await furrow('render', '--help')).stdout).toContain('--expression surprised')
  })

  test('refuses an unknown command', async () => {
    await expectRefusal(await furrow('wrinkle'), /unknown command 'wrinkle'/)
  })
})

function furrow(...words: string[]): Promise<Ended> {
  return furrowWith({}, ...words)
}

function furrowWith(env: NodeJS.ProcessEnv, ...words: string[]): Promise<Ended> {
  return runFurrow(folder, env, ...words)
}

/** One line on stderr that says what is wrong, and nothing else. */
function expectRefusal({ code, stdout, stderr }: Ended, message: RegExp): void {
  expect(stderr).toMatch(message)
  expect(stderr.trimEnd().split('\n')).toHaveLength(1)
  expect(stdout).toBe('')
  expect(code).toBe(1)
}

/** Every file below a folder. */
async function listing(path: string): Promise<string[]> {
  return (await readdir(path, { recursive: true })).sort()
}

function setWith(normal: string): object {
  return {
    version: 1,
    layers: [{ name: 'expression', kind: 'replace', normal }],
    areas: [{ name: 'forehead', image: normal }],
  }
}

async function read(file: string): Promise<CanvasPixels> {
  const { data, info } = await sharp(file).removeAlpha().raw().toBuffer({ resolveWithObject: true })
  return { width: info.width, height: info.height, data }
}
