import { readFileSync } from 'node:fs'
import { beforeAll, describe, expect, it } from 'vitest'
import { packCommand } from '../../../packages/cli/src/commands/pack.ts'
import { unpackCommand } from '../../../packages/cli/src/commands/unpack.ts'
import { validateCommand } from '../../../packages/cli/src/commands/validate.ts'
import { faceBytes, jsonOf, noise, painted, Workshop, withJson } from './workshop.ts'

const NAME = 'FURROW_wrinkle_maps'
const shop = new Workshop()

/** Legal names that no file can have, or that some file system takes for one another. */
const ODD_NAMES = [
  '額'.repeat(84),
  'x'.repeat(256),
  'a#b',
  'a?b%20c',
  'CON',
  '.hidden',
  '../up',
  'a\\b',
  'Brow',
  'brow',
  'caf\u00e9',
  'cafe\u0301',
  'ends.',
  ' ',
  'a\u202eb',
  '__proto__',
]

beforeAll(async () => {
  const folder = await shop.makeFolder('plain')
  for (const [i] of ODD_NAMES.entries()) shop.write(`plain/areas/${i}.png`, await painted(i % 8))
  shop.json('plain/wrinkles.json', {
    version: 1,
    layers: [
      { name: 'age/../old', normal: 'layers/age/normal.png' },
      { name: 'CON', normal: 'layers/expression/normal.png' },
      { name: 'age_.._old', normal: 'layers/expression/normal.png' },
    ],
    areas: ODD_NAMES.map((name, i) => ({ name, image: `areas/${i}.png` })),
    drivers: ODD_NAMES.map((area) => ({ type: 'morph', area, targets: [{ name: 'browInnerUp' }] })),
  })
  await shop.run(packCommand, folder, '-o', shop.path('one.glb'))
})

describe('names of areas and layers', () => {
  it('make the round trip to a folder and back, whatever they are', async () => {
    await shop.run(unpackCommand, shop.path('one.glb'), '-o', shop.path('folder'))
    await shop.run(packCommand, shop.path('folder'), '-o', shop.path('two.glb'))
    const [one, two] = ['one.glb', 'two.glb'].map((name) => readFileSync(shop.path(name)))
    const maps = jsonOf(two).materials[0].extensions[NAME]
    expect(maps.areas.map(({ name }: { name: string }) => name)).toEqual(ODD_NAMES)
    expect(maps.layers.map(({ name }: { name: string }) => name)).toEqual(['age/../old', 'CON', 'age_.._old'])
    expect(two.equals(one)).toBe(true)
  })

  it('are found in names of files that mean something in addresses', async () => {
    shop.write('signs/face.glb', await faceBytes())
    shop.write('signs/layers/50%/normal.png', await noise(1, 3))
    shop.write('signs/areas/a#b.png', await painted(1))
    shop.write('signs/areas/a%20b.png', await painted(2))
    await shop.run(packCommand, shop.path('signs'), '-o', shop.path('signs.glb'))
    const maps = jsonOf(readFileSync(shop.path('signs.glb'))).materials[0].extensions[NAME]
    expect(maps.areas.map(({ name }: { name: string }) => name)).toEqual(['a#b', 'a%20b'])
    expect(maps.layers[0].name).toBe('50%')
  })

  it.each(['a\nb', '\u001b[2J', '', 'x'.repeat(257), '\ud800'])(
    'are refused by every command where no name may be %j',
    async (name) => {
      const bytes = readFileSync(shop.path('one.glb'))
      const json = jsonOf(bytes)
      const maps = json.materials[0].extensions[NAME]
      Object.assign(maps.areas[3], { name })
      delete maps.drivers
      const path = shop.write('illegal.glb', withJson(bytes, json))
      const failure = await shop.failure(unpackCommand, path, '-o', shop.path('illegal'))
      expect(failure.message).toContain('areas[3].name must be text')
      await shop.run(validateCommand, path)
      expect(shop.printed).toContain('areas[3].name must be text')
      expect(process.exitCode).toBe(1)
      shop.json('plain/illegal.json', { version: 1, areas: [{ name, image: 'areas/1.png' }] })
      const folder = await shop.makeFolder('illegal-folder')
      shop.json('illegal-folder/wrinkles.json', {
        version: 1,
        areas: [{ name, image: 'areas/nose.png' }],
      })
      const refused = await shop.failure(packCommand, folder, '-o', shop.path('x.glb'))
      expect(refused.message).toContain('areas[0].name must be text')
    },
  )
})

describe('the mesh that wrinkles', () => {
  it('is remembered by the folder that a face is unpacked to', async () => {
    const folder = await shop.makeFolder('two')
    shop.write('two/face.glb', await faceBytes(['left', 'right']))
    await shop.run(packCommand, folder, '--mesh', 'right', '-o', shop.path('right.glb'))
    await shop.run(unpackCommand, shop.path('right.glb'), '-o', shop.path('right'))
    const document = JSON.parse(readFileSync(shop.path('right/wrinkles.json'), 'utf8'))
    expect(document).toMatchObject({ mesh: 'right', material: 'right' })
    await shop.run(packCommand, shop.path('right'), '-o', shop.path('again.glb'))
    expect(readFileSync(shop.path('again.glb')).equals(readFileSync(shop.path('right.glb')))).toBe(true)
  })

  it('is remembered by its index where it has no name of its own', async () => {
    const folder = await shop.makeFolder('nameless')
    const face = await faceBytes(['left', 'right'])
    const json = jsonOf(face)
    for (const item of [...json.meshes, ...json.nodes, ...json.materials]) delete item.name
    shop.write('nameless/face.glb', withJson(face, json))
    await shop.run(packCommand, folder, '--mesh', '1', '-o', shop.path('1.glb'))
    await shop.run(unpackCommand, shop.path('1.glb'), '-o', shop.path('1'))
    await shop.run(packCommand, shop.path('1'), '-o', shop.path('1-again.glb'))
    expect(readFileSync(shop.path('1-again.glb')).equals(readFileSync(shop.path('1.glb')))).toBe(true)
    expect(jsonOf(readFileSync(shop.path('1.glb'))).materials[1].extensions[NAME]).toBeDefined()
  })

  it('is the one that the blendshapes move most where none is named', async () => {
    const folder = await shop.makeFolder('moved')
    const face = await faceBytes(['teeth', 'head'])
    const json = jsonOf(face)
    // The teeth keep still.
    delete json.meshes[0].primitives[0].targets
    shop.write('moved/face.glb', withJson(face, json))
    await shop.run(packCommand, folder, '-o', shop.path('moved.glb'))
    expect(jsonOf(readFileSync(shop.path('moved.glb'))).materials[1].extensions[NAME]).toBeDefined()
  })
})
