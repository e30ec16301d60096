import { closeSync, openSync, truncateSync } from 'node:fs'
import { readBytes } from 'furrow-files/node'
import { beforeAll, describe, expect, it } from 'vitest'
import { MAX_FILE_BYTES } from '../../../packages/files/src/base/file-size.ts'
import type { CommandName } from '../../commands.ts'
import { ONE_LINE } from '../../strokes.ts'
import { faceBytes, Workshop } from './workshop.ts'

const MIB = 2 ** 20
const HUGE = 1900 * MIB

const shop = new Workshop()
const at = (name: string) => shop.path(name)

/** Creates a sparse file: the bytes of `begin`, then zeros. */
function sparse(name: string, bytes: number, begin: Uint8Array = Buffer.alloc(0)): string {
  const path = shop.write(name, begin)
  truncateSync(path, bytes)
  return path
}

/** Returns the first bytes of a binary glTF file that declares these lengths of the file and of its JSON. */
function header(length: number, jsonLength: number): Buffer {
  const head = Buffer.alloc(20)
  for (const [i, value] of [0x46546c67, 2, length, jsonLength, 0x4e4f534a].entries()) {
    head.writeUInt32LE(value, 4 * i)
  }
  return head
}

/** Expects a one-line error, and that the command has read little more than the header. */
async function expectRefusal(message: string | RegExp, command: CommandName, args: string[]): Promise<void> {
  const before = process.resourceUsage().fsRead
  const { rss } = process.memoryUsage()
  const failure = await shop.failure(command, ...args)
  expect(failure.name, failure.stack).toBe('FurrowError')
  expect(failure.message).toMatch(message)
  expect(process.memoryUsage().rss - rss).toBeLessThan(256 * MIB)
  expect(process.resourceUsage().fsRead - before).toBeLessThan(1000)
}

beforeAll(async () => {
  shop.write('face.glb', await faceBytes())
  await shop.makeFolder('folder')
  shop.json('strokes.json', ONE_LINE)
  sparse('huge.glb', HUGE, header(HUGE, 1000))
  sparse('huge.json', HUGE, Buffer.from('{'))
  sparse('huge.png', HUGE, Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'))
  sparse('huge.ktx2', HUGE, Buffer.from('\xabKTX 20\xbb\r\n\x1a\n', 'latin1'))
})

describe('a file of 1.9 GB is refused before it is read', () => {
  it.each<[CommandName, () => string[]]>([
    ['activations', () => [at('huge.glb')]],
    ['auto', () => [at('huge.glb'), '-o', at('x.glb')]],
    ['bake', () => [at('huge.glb'), at('face.glb'), '-o', at('x.png')]],
    ['bake', () => [at('face.glb'), at('huge.glb'), '-o', at('x.png')]],
    ['inspect', () => [at('huge.glb')]],
    ['pack', () => [at('folder'), '--face', at('huge.glb'), '-o', at('x.glb')]],
    ['render', () => [at('huge.glb'), '-o', at('x.png')]],
    ['strokes', () => [at('strokes.json'), '--face', at('huge.glb'), '-o', at('x.png')]],
    ['unpack', () => [at('huge.glb'), '-o', at('x')]],
    ['uv', () => [at('huge.glb'), '-o', at('x.png')]],
    ['validate', () => [at('huge.glb')]],
  ])('for a face: %#', async (command, args) => {
    const message = /huge\.glb is too large, got "1900 MiB", allowed: 512 MiB; make it smaller$/
    await expectRefusal(message, command, args())
  })

  it.each<[string, CommandName, () => string[]]>([
    ['an image of an array', 'array', () => [at('huge.png'), '-o', at('x.ktx2')]],
    ['an array', 'array', () => [at('huge.ktx2'), '--extract', at('x')]],
    ['heights', 'normals', () => [at('huge.png'), '-o', at('x.png'), '--strength', '1']],
    [
      'a base',
      'strokes',
      () => [at('strokes.json'), '--face', at('face.glb'), '--base', at('huge.png'), '--normal', at('x.png')],
    ],
    ['strokes', 'strokes', () => [at('huge.json'), '--face', at('face.glb'), '-o', at('x.png')]],
    ['a wrinkle set', 'render', () => [at('face.glb'), '--wrinkles', at('huge.json'), '-o', at('x.png')]],
  ])('for %s', (_, command, args) => {
    return expectRefusal(/huge\.\w+ is too large, got "1900 MiB", allowed: (512|64) MiB/, command, args())
  })

  it('in a folder of wrinkles', async () => {
    await shop.makeFolder('big')
    sparse('big/areas/brow.png', HUGE)
    const message = /brow\.png, referenced by .*, is too large, got "1900 MiB"/
    await expectRefusal(message, 'pack', [at('big'), '-o', at('x.glb')])
    sparse('big/wrinkles.json', HUGE)
    await expectRefusal(/wrinkles\.json is too large/, 'pack', [at('big'), '-o', at('x.glb')])
  })

  it('next to a face, alone or in total', async () => {
    sparse('beside/huge.bin', HUGE)
    sparse('beside/a.bin', 300 * MIB)
    sparse('beside/b.bin', 300 * MIB)
    const face = (...files: string[]) =>
      shop.json('beside/face.gltf', {
        asset: { version: '2.0' },
        buffers: files.map((uri) => ({ byteLength: 1, uri })),
      })
    await expectRefusal(/huge\.bin, referenced by .*face\.gltf, is too large/, 'inspect', [face('huge.bin')])
    const failure = await shop.failure('inspect', face('a.bin', 'b.bin'))
    expect(failure.message).toMatch(
      /face\.gltf with its referenced files is too large, got "600 MiB", allowed: 512 MiB/,
    )
  })
})

describe('a file of 500 MB is refused by its first bytes', () => {
  const inspect = (path: string, message: RegExp) => expectRefusal(message, 'inspect', [path])

  it('if it is not glTF', async () => {
    await inspect(sparse('zeros.glb', 500 * MIB), /does not begin with "glTF"/)
    await inspect(sparse('text.glb', 500 * MIB, Buffer.from('x'.repeat(1024))), /it is text, not glTF/)
  })

  it('if its header gives another length', () => {
    return inspect(sparse('cut.glb', 500 * MIB, header(501 * MIB, 1000)), /it is truncated: \d+ of \d+ bytes/)
  })

  it('if it is JSON, or its JSON is equally large', async () => {
    const message = /the JSON of .* is too large, got "500 MiB", allowed: 64 MiB of JSON/
    await inspect(sparse('text.gltf', 500 * MIB, Buffer.from('{')), message)
    await inspect(sparse('json.glb', 501 * MIB, header(501 * MIB, 500 * MIB)), message)
  })
})

it('a pipe is read up to the limit, and no further', async () => {
  const zeros = openSync('/dev/zero', 'r')
  try {
    await expect(
      readBytes(`/dev/fd/${zeros}`, 'furrow test', 'the face', { maxBytes: 3 * MIB }),
    ).rejects.toThrow(/the face \/dev\/fd\/\d+ is too large, got "4 MiB", allowed: 3 MiB/)
  } finally {
    closeSync(zeros)
  }
  expect(MAX_FILE_BYTES).toBe(512 * MIB)
})
