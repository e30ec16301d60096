import { beforeAll, describe, test } from 'vitest'
import { writeSheet } from './sheet.ts'
import { bench } from './workshop.ts'

const { shop, file, fails } = bench('auto')

beforeAll(() => writeSheet(file('body.glb')))

describe('a preset', () => {
  test('with regions requires a face', async () => {
    const path = shop.json('chin.json', { version: 1, regions: ['chin'] })
    await fails('regions require a face', file('body.glb'), '-o', file('x.glb'), '--preset', path)
  })

  test.each([
    ['that is missing', undefined, 'cannot read the preset'],
    ['that is no JSON', 'age: 60', 'cannot read the preset'],
    ['that is another file', 'glTF\x02\0\0\0', 'it is a binary glTF file'],
    ['of a later version', '{"version":2}', 'unknown version of the preset, got 2, allowed: 1'],
    ['with an unknown region', '{"version":1,"strengths":{"eyes":1}}', 'unknown region, got "eyes"'],
    [
      'with text for a number',
      '{"version":1,"age":"old"}',
      'invalid age, got "old", allowed: a number, 20 to 80',
    ],
    ['with deep nesting', `{"version":1,"seeds":${'['.repeat(1e5)}${']'.repeat(1e5)}}`, 'preset'],
  ])('%s is an error of one line', async (_, text, message) => {
    const path = text === undefined ? file('none.json') : shop.write('bad.json', text)
    await fails(message, file('body.glb'), '-o', file('x.glb'), '--preset', path)
  })
})
