import { mkdirSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { BARE_FACES } from '../../bare-faces/bare-faces.ts'
import { drawAndPack } from '../../bare-faces/draw-and-pack.ts'
import { Workshop } from './workshop.ts'

const shop = new Workshop()

describe.each(BARE_FACES)('$name with drawn wrinkles', (face) => {
  it.each([
    ['png', []],
    ['ktx2', ['--ktx2', '--size', '512']],
  ])('is valid without warnings after packing as %s', async (name, options) => {
    const folder = shop.path(`${face.name} ${name}`)
    mkdirSync(folder)
    const packed = await drawAndPack(face, folder, (...words) => shop.run(...words), ...options)
    expect(await shop.output('validate', packed)).toBe(`${packed}: 0 errors, 0 warnings\n`)
  })
})
