import { readdirSync, readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { writeSheet } from './sheet.ts'
import { bench } from './workshop.ts'

const at = bench('auto')
const { file } = at

test.each([
  ['PNG', []],
  ['KTX 2', ['--ktx2']],
])('auto stores its lines in the file, with maps as %s', async (kind, options) => {
  await writeSheet(file('sheet.glb'))
  const [out, lines, folder] = [file(`${kind}.glb`), file(`${kind}.json`), file(kind)]
  await at.run(file('sheet.glb'), '-o', out, '--size', '512', '--strokes', lines, ...options)
  await at.shop.run('unpack', out, '-o', folder)
  expect(JSON.parse(readFileSync(lines, 'utf8')).strokes.length).toBeGreaterThan(3)
  expect(readFileSync(`${folder}/strokes.json`)).toEqual(readFileSync(lines))
})

test('furrow strokes draws the same maps from them, byte for byte', async () => {
  const [out, folder] = [file('human.glb'), file('human')]
  await at.run('faces/human.glb', '-o', out, '--replace', '--size', '512', '--layers', '2')
  await at.shop.run('unpack', out, '-o', folder)
  const maps = () => {
    const names = readdirSync(`${folder}/layers`, { recursive: true, encoding: 'utf8' }).sort()
    return names.flatMap((name) =>
      name.endsWith('.png') ? [[name, readFileSync(`${folder}/layers/${name}`)]] : [],
    )
  }
  const made = maps()
  expect(made).toHaveLength(8)
  const args = [`${folder}/strokes.json`, '--face', `${folder}/face.glb`, '--into', folder]
  await at.shop.run('strokes', ...args)
  for (const [i, [name, bytes]] of maps().entries()) {
    expect(name).toBe(made[i][0])
    expect((bytes as Buffer).equals(made[i][1] as Buffer), name as string).toBe(true)
  }
})

test('strokes are valid on a skin in another texture tile that exceeds the tile', async () => {
  await writeSheet(file('tile.glb'), (shape) => {
    // Up to 1 mm beyond the edges of the tile.
    shape.uvs = shape.uvs!.map((value) => 1 + 1.006 * value - 0.003)
  })
  await at.run(file('tile.glb'), '-o', file('out.glb'), '--size', '512', '--age', '80', '--strength', '2')
  expect(await at.shop.output('validate', file('out.glb'))).not.toContain('STROKES')
  expect(
    JSON.parse(await at.shop.output('inspect', file('out.glb'), '--json')).strokes.count,
  ).toBeGreaterThan(3)
})
