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

/** Returns path and bytes of each map of a folder's layers. */
const mapsIn = (folder: string) =>
  readdirSync(`${folder}/layers`, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.png'))
    .sort()
    .map((name) => [name, readFileSync(`${folder}/layers/${name}`, 'base64')] as const)

test('maps survive strokes, pack and unpack byte for byte', async () => {
  const [out, folder] = [file('human.glb'), file('human')]
  await at.run('faces/human.glb', '-o', out, '--replace', '--size', '512', '--layers', '2')
  await at.shop.run('unpack', out, '-o', folder)
  const made = mapsIn(folder)
  expect(made).toHaveLength(10)
  const args = [`${folder}/strokes.json`, '--face', `${folder}/face.glb`, '--into', folder]
  await at.shop.run('strokes', ...args)
  expectSame(mapsIn(folder), made)

  const [packed, again, twice] = [file('packed.glb'), file('again'), file('twice.glb')]
  await at.shop.run('pack', folder, '-o', packed)
  await at.shop.run('unpack', packed, '-o', again)
  expectSame(mapsIn(again), made)
  await at.shop.run('pack', again, '-o', twice)
  expect(readFileSync(twice).equals(readFileSync(packed))).toBe(true)
})

/** Compares maps one by one, because a difference of long strings is unreadable. */
function expectSame(maps: ReturnType<typeof mapsIn>, made: ReturnType<typeof mapsIn>): void {
  expect(maps.map(([name]) => name)).toEqual(made.map(([name]) => name))
  for (const [i, [name, bytes]] of maps.entries()) expect(bytes === made[i][1], name).toBe(true)
}

test('strokes are valid if the skin is in another UV tile and extends beyond it', async () => {
  await writeSheet(file('tile.glb'), (shape) => {
    // The coordinates exceed the tile by up to 1 mm of skin.
    shape.uvs = shape.uvs!.map((value) => 1 + 1.006 * value - 0.003)
  })
  await at.run(file('tile.glb'), '-o', file('out.glb'), '--size', '512', '--age', '80', '--strength', '2')
  expect(await at.shop.output('validate', file('out.glb'))).not.toContain('STROKES')
  expect(
    JSON.parse(await at.shop.output('inspect', file('out.glb'), '--json')).strokes.count,
  ).toBeGreaterThan(3)
})
