import { readFileSync, writeFileSync } from 'node:fs'
import { expect, it } from 'vitest'
import { Workshop } from './workshop.ts'

const shop = new Workshop()
const DEEP = `${'['.repeat(20_000)}${']'.repeat(20_000)}`

it.each([
  [
    'is too deep for what reads it',
    `{ "areas": [{ "combine": ${DEEP} }] }`,
    ' (its JSON is more than 128 levels deep); correct the file',
  ],
  [
    'names a layer by an object',
    '{ "layers": [{ "name": { "toString": 1 } }] }',
    ': layers[0].name must be text',
  ],
  ['names a layer by a number', '{ "layers": [{ "name": 1 }] }', ': layers[0].name must be text'],
])('pack refuses a wrinkles.json that %s', async (_, text, problem) => {
  const folder = await shop.makeFolder('misnamed')
  const path = shop.write('misnamed/wrinkles.json', text)
  await expect(shop.run('pack', folder, '-o', shop.path('out.glb'))).rejects.toThrow(`${path}${problem}`)
})

it('pack names a damaged layer, also when it scales layers', async () => {
  const folder = await shop.makeFolder('damaged')
  const layer = `${folder}/layers/age/normal.png`
  const png = readFileSync(layer)
  // This byte is in the checksum of the header (PNG specification, 5.3).
  png[30]! ^= 1
  writeFileSync(layer, png)
  const message = /cannot read the image .*normal\.png/
  await shop.fails(message, 'pack', folder, '-o', shop.path('out.glb'), '--size', '32')
})
