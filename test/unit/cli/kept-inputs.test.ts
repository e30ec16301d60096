// Tests that no command overwrites a file that it reads: neither an input nor a file to which an input refers.

import { lstatSync, mkdirSync, readFileSync, rmSync, symlinkSync } from 'node:fs'
import { readGlbFile } from 'furrow-files/node'
import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import { writeAll } from '../../../packages/cli/src/files.ts'
import { type CommandName, commandOf } from '../../commands.ts'
import { sheet, sheetGlb } from './sheet.ts'
import { painted, Workshop } from './workshop.ts'

const shop = new Workshop()
const at = (name: string) => shop.path(name)
const FACE = at('face.glb')
const STROKES = at('strokes.json')

/** Name of a file to which the face refers, a command, and arguments that would overwrite the file. */
type Row = [name: string, command: CommandName, args: (face: string) => string[]]

/** A row for each output of each command. The output is a texture or the buffer of the input face. */
const ROWS: Row[] = [
  ['a.png', 'uv', (face) => [face, '-o', at('in/a.png'), '--size', '64']],
  ['a.png', 'inspect', (face) => [face, '--sheet', at('in/a.png')]],
  ['a.png', 'bake', (face) => [FACE, face, '-o', at('in/a.png'), '--size', '16']],
  ['a.png', 'bake', (face) => [face, FACE, '-o', at('in/a.png'), '--size', '16']],
  ['a.png', 'bake', (face) => [FACE, face, '--height', at('in/a.png'), '--size', '16']],
  [
    'a.png',
    'bake',
    (face) => [FACE, face, '--occlusion', at('in/a.png'), '--size', '16', '--rays', '1', '--samples', '1'],
  ],
  ['a.glb', 'auto', (face) => [face, '-o', at('in/a.glb'), '--size', '512']],
  ['a-1.png', 'auto', (face) => [face, '-o', at('in/a.gltf'), '--size', '512']],
  ['a.bin', 'auto', (face) => [face, '-o', at('in/a.gltf'), '--size', '512']],
  ['a.json', 'auto', (face) => [face, '-o', at('out.glb'), '--strokes', at('in/a.json'), '--size', '512']],
  ['a.glb', 'pack', (face) => [at('set'), '--face', face, '-o', at('in/a.glb')]],
  ['a.bin', 'pack', (face) => [at('set'), '--face', face, '-o', at('in/a.gltf')]],
  ['a.png', 'strokes', (face) => [STROKES, '--face', face, '-o', at('in/a.png'), '--size', '64']],
  ['a.png', 'strokes', (face) => [STROKES, '--face', face, '--normal', at('in/a.png'), '--size', '64']],
  ['areas/brow.png', 'strokes', (face) => [STROKES, '--face', face, '--areas', at('in/areas')]],
  [
    'layers/expression/normal.png',
    'strokes',
    (face) => [STROKES, '--face', face, '--into', at('in'), '--size', '64'],
  ],
]

beforeAll(async () => {
  shop.write('face.glb', await sheetGlb(sheet(20)))
  shop.write('image.png', await painted(1, 16))
  await shop.makeFolder('set')
  shop.json('strokes.json', {
    version: 1,
    strokes: [
      {
        points: [
          [0.2, 0.5],
          [0.8, 0.5],
        ],
        width: 2,
        depth: 0.5,
        group: 'brow',
      },
    ],
  })
})

beforeEach(() => {
  rmSync(at('in'), { recursive: true, force: true })
  mkdirSync(at('in'))
})

/** Writes a face that refers to a buffer, a texture, and a second buffer with this name. */
async function faceWith(name: string): Promise<string> {
  const { json, bin } = await readGlbFile(FACE, 'test')
  const isImage = name.endsWith('.png')
  shop.write(`in/${name}`, isImage ? readFileSync(at('image.png')) : bin)
  shop.write('in/mesh.bin', bin)
  json.buffers![0].uri = isImage ? 'mesh.bin' : name
  if (isImage) json.images = [{ uri: name }]
  json.textures = isImage ? [{ source: 0 }] : undefined
  if (isImage) json.materials![0].pbrMetallicRoughness = { baseColorTexture: { index: 0 } }
  return shop.json('in/face.gltf', json)
}

const hasForce = async (command: CommandName) =>
  (await commandOf(command)).options.some(({ long }) => long === '--force')

describe.each(ROWS)('%s referenced by a face', (name, command, args) => {
  it(`is kept by furrow ${command} ${args('FACE').slice(-4).join(' ')}`, async () => {
    const face = await faceWith(name)
    const before = shop.files('in')
    await shop.fails(' is the input; ', command, ...args(face))
    expect(shop.files('in')).toEqual(before)
  })

  it('is replaced with --force, but only if the command line names it as output', async () => {
    if (!(await hasForce(command))) return
    const face = await faceWith(name)
    const before = shop.files('in')
    const isNamed = args(face).includes(at(`in/${name}`))
    const error = await shop.run(command, ...args(face), '--force').catch((error: Error) => error)
    const after = shop.files('in')
    const changed = Object.keys(before).filter((path) => after[path] !== before[path])
    expect(changed).toEqual(isNamed ? [name] : [])
    if (error) expect(error.message).toContain(' is the input; choose another output')
  })
})

it('a .gltf that replaces itself keeps its old separate files, which other files may use', async () => {
  const face = await faceWith('face-1.png')
  shop.write('in/face.bin', readFileSync(at('in/mesh.bin')))
  const json = JSON.parse(readFileSync(face, 'utf8'))
  json.buffers[0].uri = 'face.bin'
  shop.json('in/face.gltf', json)
  shop.json('in/twin.gltf', json)
  const before = shop.files('in')
  await shop.run('auto', face, '-o', face, '--force', '--size', '512')
  const after = shop.files('in')
  expect(Object.keys(before).filter((path) => after[path] !== before[path])).toEqual(['face.gltf'])
  shop.printed = ''
  await shop.run('inspect', face)
  expect(shop.printed).toContain('wrinkles on material "cloth"')
})

it('the strokes document may be in the new folder that it is drawn into', async () => {
  const document = shop.write('own/strokes.json', readFileSync(STROKES))
  await shop.run('strokes', document, '--face', FACE, '--into', at('own'), '--size', '64')
  expect(readFileSync(document)).toEqual(readFileSync(STROKES))
  // Strokes may be drawn again into the folder that contains their document.
  await shop.run('strokes', document, '--face', FACE, '--into', at('own'), '--size', '64')
})

it('files read by an earlier command can be outputs', async () => {
  await shop.run('uv', FACE, '-o', at('uv.png'), '--size', '64')
  await shop.run('array', at('uv.png'), '-o', at('uv.ktx2'))
  await shop.run('uv', FACE, '-o', at('uv.png'), '--size', '64')
})

it('temporary files have unpredictable names', async () => {
  shop.write('precious', 'precious')
  mkdirSync(at('shared'))
  for (let i = 0; i < 2000; i++) symlinkSync('../precious', at(`shared/.furrow-${process.pid}-${i}.tmp`))
  await writeAll([{ path: at('shared/a.png'), bytes: Buffer.from('a') }], 'furrow test')
  expect(readFileSync(at('precious'), 'utf8')).toBe('precious')
  expect(lstatSync(at('shared/a.png')).isFile()).toBe(true)
})
