import { mkdirSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { validateCommand } from '../../../packages/cli/src/commands/validate.ts'
import { hasScan, packScan } from '../../real-face/pack-scan.ts'
import { Workshop } from './workshop.ts'

const shop = new Workshop()

describe.skipIf(!hasScan)('a scanned face with drawn wrinkles', () => {
  it.each([
    ['png', []],
    ['ktx2', ['--ktx2', '--size', '512']],
  ])('is valid to the last warning once it is packed as %s', async (name, options) => {
    const folder = shop.path(name)
    mkdirSync(folder)
    const packed = await packScan(folder, shop.run, ...options)
    shop.printed = ''
    await shop.run(validateCommand, packed)
    expect(shop.printed).toBe(`${packed}: 0 errors, 0 warnings\n`)
  })
})
