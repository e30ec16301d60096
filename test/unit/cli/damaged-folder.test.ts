import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, it } from 'vitest'
import { Workshop } from './workshop.ts'

const shop = new Workshop()

it('pack refuses a wrinkles.json that is too deep for what reads it', async () => {
  const folder = await shop.makeFolder('deep')
  const deep = '['.repeat(20_000) + ']'.repeat(20_000)
  writeFileSync(join(folder, 'wrinkles.json'), `{ "version": 1, "areas": [{ "combine": ${deep} }] }`)
  await expect(shop.run('pack', folder, '-o', shop.path('out.glb'))).rejects.toThrow(
    /wrinkles\.json \(its JSON is more than 128 levels deep\); correct the file/,
  )
})

it.each([{ toString: 1, valueOf: null }, 1])('pack refuses a layer whose name is %j', async (name) => {
  const folder = await shop.makeFolder('misnamed')
  shop.json('misnamed/wrinkles.json', { layers: [{ name }] })
  await expect(shop.run('pack', folder, '-o', shop.path('out.glb'))).rejects.toThrow(
    /wrinkles\.json: layers\[0\]\.name must be text/,
  )
})

it('pack names a damaged layer also where it scales it', async () => {
  const folder = await shop.makeFolder('damaged')
  const layer = join(folder, 'layers/age/normal.png')
  const png = readFileSync(layer)
  // In the checksum of the header (PNG, 5.3).
  png[30]! ^= 1
  writeFileSync(layer, png)
  await expect(shop.run('pack', folder, '-o', shop.path('out.glb'), '--size', '32')).rejects.toThrow(
    /furrow pack: cannot read the image .*normal\.png/,
  )
})
