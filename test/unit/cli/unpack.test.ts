import { readFileSync } from 'node:fs'
import { beforeAll, describe, it } from 'vitest'
import { editGlb } from '../../glb.ts'
import { Workshop } from './workshop.ts'

const shop = new Workshop()

describe('furrow unpack with invalid input', () => {
  beforeAll(async () => {
    await shop.run('pack', await shop.makeFolder('face'), '-o', shop.path('a.glb'))
  })

  it.each([
    ['a.glb', 'face', 'face is not empty, allowed: a new or empty folder'],
    ['face/face.glb', 'new', 'has no wrinkles'],
  ])('refuses %s to %s', async (from, to, message) => {
    await shop.fails(message, 'unpack', shop.path(from), '-o', shop.path(to))
  })

  it("names the problem of a file's wrinkles", async () => {
    const wrong = editGlb(readFileSync(shop.path('a.glb')), ({ materials }) => {
      materials[0].extensions.FURROW_wrinkle_maps.areas[0].texture.index = 99
    })
    const message = 'areas[0].texture.index is out of range'
    await shop.fails(message, 'unpack', shop.write('wrong.glb', wrong), '-o', shop.path('wrong'))
  })
})
