import { readFileSync } from 'node:fs'
import { parseWrinkleMaps } from 'furrow/internal'
import { describe, expect, test } from 'vitest'
import { BARE_FACES } from '../../bare-faces/bare-faces.ts'
import { jsonOf } from '../../glb.ts'
import { writeSheet } from './sheet.ts'
import { bench } from './workshop.ts'

const FACE = 'faces/human.glb'
const at = bench('auto')
const { file, fails } = at

const run = (...args: string[]) => at.run(...args, '--size', '512')
const output = (...args: string[]) => at.output(...args, '--size', '512')

const areasOf = (path: string) => {
  const json = jsonOf(readFileSync(path))
  return parseWrinkleMaps(json.materials[0].extensions.FURROW_wrinkle_maps, json.textures.length).areas
}

test('400,000 triangles are processed', async () => {
  await run(await writeSheet(file('fine.glb'), undefined, 448), '-o', file('out.glb'))
  expect(areasOf(file('out.glb')).length).toBeGreaterThan(0)
})

describe('the shipped face', () => {
  test('gets new wrinkles, and --areas keeps the areas with the most compression', async () => {
    await fails('the material already has wrinkles', FACE, '-o', file('x.glb'))
    await run(FACE, '-o', file('all.glb'), '--replace', '--json')
    const all = JSON.parse(at.printed)
    expect(all.isFace).toBe(true)
    expect(at.warned).toBe('')
    const few = JSON.parse(await output(FACE, '-o', file('few.glb'), '--replace', '--json', '--areas', '5'))
    const compressions = ({ areas }: typeof all) =>
      areas.map((area: { compression: number }) => area.compression).sort((a: number, b: number) => a - b)
    expect(few.areas).toHaveLength(5)
    expect(compressions(few)).toEqual(compressions(all).slice(-5))
  })

  test('gets wrinkles only in the named regions', async () => {
    await run(FACE, '-o', file('some.glb'), '--replace', '--regions', 'upperLip', 'crowsFeet')
    const names = areasOf(file('some.glb')).map(({ name }) => name)
    expect(names).toEqual(['crowsFeetLeft', 'crowsFeetRight', 'upperLip', 'paleLips'])
  })
})

test.each(BARE_FACES)('$name is a face', async ({ path }) => {
  await run(path, '-o', file('bare.glb'), '--json')
  const { isFace, areas } = JSON.parse(at.printed)
  expect(isFace).toBe(true)
  expect(areas.length).toBeGreaterThanOrEqual(8)
})
