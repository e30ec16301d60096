import { readFileSync } from 'node:fs'
import { beforeAll, describe, expect, it } from 'vitest'
import { editGlb } from '../../glb.ts'
import { noise } from '../../noise.ts'
import { faceBytes, painted, stillTeeth, Workshop, wrinklesIn } from './workshop.ts'

const shop = new Workshop()

/** Valid names of areas that no file can have, or that some file systems consider equal. */
const UNUSUAL_NAMES = [
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
  for (const [i] of UNUSUAL_NAMES.entries()) shop.write(`plain/areas/${i}.png`, await painted(i % 8))
  shop.json('plain/wrinkles.json', {
    version: 1,
    layers: [
      { name: 'age/../old', normal: 'layers/age/normal.png' },
      { name: 'CON', normal: 'layers/expression/normal.png' },
      { name: 'age_.._old', normal: 'layers/expression/normal.png' },
    ],
    areas: UNUSUAL_NAMES.map((name, i) => ({ name, image: `areas/${i}.png` })),
    drivers: UNUSUAL_NAMES.map((area) => ({ type: 'morph', area, targets: [{ name: 'browInnerUp' }] })),
  })
  await shop.run('pack', folder, '-o', shop.path('one.glb'))
})

describe('names of areas and layers', () => {
  it('survive packing and unpacking, also if unusual', async () => {
    await shop.run('unpack', shop.path('one.glb'), '-o', shop.path('folder'))
    await shop.run('pack', shop.path('folder'), '-o', shop.path('two.glb'))
    const [one, two] = ['one.glb', 'two.glb'].map((name) => readFileSync(shop.path(name)))
    const maps = wrinklesIn(shop.path('two.glb'))
    expect(maps.areas.map(({ name }: { name: string }) => name)).toEqual(UNUSUAL_NAMES)
    expect(maps.layers.map(({ name }: { name: string }) => name)).toEqual(['age/../old', 'CON', 'age_.._old'])
    expect(two.equals(one)).toBe(true)
  })

  it('are found in file names with characters that URLs escape', async () => {
    shop.write('signs/face.glb', await faceBytes())
    shop.write('signs/layers/50%/normal.png', await noise(1))
    shop.write('signs/areas/a#b.png', await painted(1))
    shop.write('signs/areas/a%20b.png', await painted(2))
    await shop.run('pack', shop.path('signs'), '-o', shop.path('signs.glb'))
    const maps = wrinklesIn(shop.path('signs.glb'))
    expect(maps.areas.map(({ name }: { name: string }) => name)).toEqual(['a#b', 'a%20b'])
    expect(maps.layers[0].name).toBe('50%')
  })

  it('are refused by every command if invalid', async () => {
    const bytes = editGlb(readFileSync(shop.path('one.glb')), ({ materials }) => {
      const maps = materials[0].extensions.FURROW_wrinkle_maps
      maps.areas[3].name = 'a\nb'
      delete maps.drivers
    })
    const path = shop.write('illegal.glb', bytes)
    await shop.fails('areas[3].name must be text', 'unpack', path, '-o', shop.path('illegal'))
    expect(await shop.output('validate', path)).toContain('areas[3].name must be text')
    expect(process.exitCode).toBe(1)
    const folder = await shop.makeFolder('illegal-folder')
    shop.json('illegal-folder/wrinkles.json', { areas: [{ name: 'a\nb', image: 'areas/nose.png' }] })
    await shop.fails('areas[0].name must be text', 'pack', folder, '-o', shop.path('x.glb'))
  })
})

describe('the wrinkled mesh', () => {
  it('is named in the folder to which a face is unpacked', async () => {
    const folder = await shop.makeFolder('two')
    shop.write('two/face.glb', await faceBytes(['left', 'right']))
    await shop.run('pack', folder, '--mesh', 'right', '-o', shop.path('right.glb'))
    await shop.run('unpack', shop.path('right.glb'), '-o', shop.path('right'))
    const document = JSON.parse(readFileSync(shop.path('right/wrinkles.json'), 'utf8'))
    expect(document).toMatchObject({ mesh: 'right', material: 'right' })
    await shop.run('pack', shop.path('right'), '-o', shop.path('again.glb'))
    expect(readFileSync(shop.path('again.glb')).equals(readFileSync(shop.path('right.glb')))).toBe(true)
  })

  it('is stored by index if it has no unique name', async () => {
    const folder = await shop.makeFolder('nameless')
    const nameless = editGlb(await faceBytes(['left', 'right']), ({ meshes, nodes, materials }) => {
      for (const item of [...meshes, ...nodes, ...materials]) delete item.name
    })
    shop.write('nameless/face.glb', nameless)
    await shop.run('pack', folder, '--mesh', '1', '-o', shop.path('1.glb'))
    await shop.run('unpack', shop.path('1.glb'), '-o', shop.path('1'))
    await shop.run('pack', shop.path('1'), '-o', shop.path('1-again.glb'))
    expect(readFileSync(shop.path('1-again.glb')).equals(readFileSync(shop.path('1.glb')))).toBe(true)
    expect(wrinklesIn(shop.path('1.glb'), 1)).toBeDefined()
  })

  it('is the mesh that blendshapes move most, if none is named', async () => {
    const folder = await shop.makeFolder('moved')
    shop.write('moved/face.glb', await stillTeeth())
    await shop.run('pack', folder, '-o', shop.path('moved.glb'))
    expect(wrinklesIn(shop.path('moved.glb'), 1)).toBeDefined()
  })
})
