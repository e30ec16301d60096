import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { checkWrinkles } from 'furrow-files'
import { readGlbFile } from 'furrow-files/node'
import sharp from 'sharp'
import { beforeAll, describe, expect, it } from 'vitest'
import { bundle } from '../../../scripts/lib/bundle.mjs'
import { flatPng } from '../../fuzz/damage-images.ts'
import { joinGlb, setImage, splitGlb } from '../../fuzz/glb-parts.ts'
import type { RunCost } from '../../fuzz/run-command.ts'
import { Workshop } from './workshop.ts'

const MAX_MEGABYTES = 1024
const MAX_SECONDS = 10

const shop = new Workshop()
let runner = ''
let folder = ''
/** PNG file of an RGBA image with 8192 x 8192 texels. */
let colours: Buffer

beforeAll(async () => {
  runner = await bundle('test/fuzz/run-command.ts')
  folder = await shop.makeFolder('face')
  const background = { r: 128, g: 128, b: 255, alpha: 1 }
  colours = await sharp({ create: { width: 8192, height: 8192, channels: 4, background } })
    .png()
    .toBuffer()
  await shop.run('pack', folder, '-o', shop.path('packed.glb'))
  await shop.run('pack', folder, '--ktx2', '-o', shop.path('packed-array.glb'))
})

/** Runs a command in a separate process, and returns its memory, time and error. */
function cost(...parameters: string[]): RunCost {
  return JSON.parse(execFileSync(process.execPath, [runner, ...parameters], { encoding: 'utf8' }))
}

/** Returns a packed face in which `change` has replaced all images. */
function withImages(name: string, change: (bytes: Buffer) => Buffer): string {
  let parts = splitGlb(readFileSync(shop.path(name)))
  for (const image of parts.json.images.keys()) {
    const { byteOffset, byteLength } = parts.json.bufferViews[parts.json.images[image].bufferView]
    parts = setImage(parts, image, change(parts.bin.subarray(byteOffset, byteOffset + byteLength)))
  }
  return shop.write('bomb.glb', joinGlb(parts))
}

const png = (side: number) => () => flatPng(side, side)

/** Returns a function that changes the size in the header of a KTX 2 image. */
const ktx2 = (side: number, layers?: number) => (bytes: Buffer) => {
  const out = Buffer.from(bytes)
  out.writeUInt32LE(side, 20)
  out.writeUInt32LE(side, 24)
  if (layers !== undefined) out.writeUInt32LE(layers, 32)
  return out
}

it('images that take more than 512 MiB in total are refused', async () => {
  const glb = await readGlbFile(withImages('packed.glb', png(8192)), 'test')
  const messages = (await checkWrinkles(glb)).map(({ message }) => message)
  expect(messages.join('\n')).toContain('total size of the wrinkle images too large')
})

describe.each(['inspect', 'validate', 'unpack'])('%s takes at most 1 GB and 10 s for', (command) => {
  it.each([
    ['PNG images of 16,000 squared', () => withImages('packed.glb', png(16_000))],
    ['PNG images of 8192 squared', () => withImages('packed.glb', png(8192))],
    ['PNG images of 8192 squared in RGBA', () => withImages('packed.glb', () => colours)],
    ['KTX 2 images of 16,384 squared', () => withImages('packed-array.glb', ktx2(16_384))],
    ['KTX 2 images of 8192 squared', () => withImages('packed-array.glb', ktx2(8192, 1))],
    ['KTX 2 arrays of 65,536 layers', () => withImages('packed-array.glb', ktx2(128, 65_536))],
  ])('%s', (_, make) => {
    const { megabytes, seconds, error } = cost(
      command,
      make(),
      ...(command === 'unpack' ? ['-o', shop.path('out')] : []),
    )
    expect(megabytes).toBeLessThan(MAX_MEGABYTES)
    expect(seconds).toBeLessThan(MAX_SECONDS)
    if (error) expect(error.name).toBe('FurrowError')
  })
})
