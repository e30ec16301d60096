import { existsSync, readFileSync } from 'node:fs'
import { beforeAll, describe, expect, it } from 'vitest'
import { packCommand } from '../../../packages/cli/src/commands/pack.ts'
import { unpackCommand } from '../../../packages/cli/src/commands/unpack.ts'
import { jsonOf, Workshop, withJson } from './workshop.ts'

const NAME = 'FURROW_wrinkle_maps'
const shop = new Workshop()

describe('furrow unpack with bad input', () => {
  beforeAll(async () => {
    await shop.run(packCommand, await shop.makeFolder('face'), '-o', shop.path('a.glb'))
  })

  it('refuses a file cut off at every 1% of its length, and leaves nothing', async () => {
    const whole = readFileSync(shop.path('a.glb'))
    for (let percent = 0; percent < 100; percent++) {
      shop.write('cut.glb', whole.subarray(0, Math.floor((whole.length * percent) / 100)))
      const failure = await shop.failure(unpackCommand, shop.path('cut.glb'), '-o', shop.path('cut'))
      expect(failure.name, `${percent}%: ${failure.stack}`).toBe('FurrowError')
      expect(failure.message).not.toContain('\n')
      expect(existsSync(shop.path('cut'))).toBe(false)
    }
  })

  it('refuses a folder that holds something, a file, and a face without wrinkles', async () => {
    const unpack = async (from: string, to: string) =>
      (await shop.failure(unpackCommand, shop.path(from), '-o', shop.path(to))).message
    expect(await unpack('a.glb', 'face')).toContain('face is not empty, allowed: a new or an empty folder')
    expect(await unpack('a.glb', 'face/face.glb')).toContain('face.glb is a file')
    expect(await unpack('face/face.glb', 'new')).toContain('has no wrinkles')
    expect(existsSync(shop.path('new'))).toBe(false)
  })

  it.each<[string, (json: ReturnType<typeof jsonOf>) => void, string]>([
    [
      'an index out of range',
      (json) => Object.assign(maps(json).areas[0].texture, { index: 99 }),
      'areas[0].texture.index is out of range',
    ],
    ['a texture without an image', (json) => json.images.pop(), 'has no image in the file'],
    [
      'an image beyond the file',
      (json) => Object.assign(json.bufferViews.at(-1), { byteLength: 1e9 }),
      'has no image in the file',
    ],
    ['meshes that are not objects', (json) => json.meshes.push(1), 'meshes[2] is malformed'],
  ])('names %s', async (_, spoil, message) => {
    const bytes = readFileSync(shop.path('a.glb'))
    const json = jsonOf(bytes)
    spoil(json)
    shop.write('wrong.glb', withJson(bytes, json))
    const failure = await shop.failure(unpackCommand, shop.path('wrong.glb'), '-o', shop.path('wrong'))
    expect(failure.name).toBe('FurrowError')
    expect(failure.message).toContain(message)
    expect(existsSync(shop.path('wrong'))).toBe(false)
  })
})

function maps(json: ReturnType<typeof jsonOf>) {
  return json.materials[0].extensions[NAME]
}
