import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { beforeAll, describe, expect, it } from 'vitest'
import { editGlb } from '../../glb.ts'
import { Workshop, wrinklesIn } from './workshop.ts'

const NAME = 'FURROW_wrinkle_maps'
const HUMAN = fileURLToPath(new URL('../../../faces/human.glb', import.meta.url))

const shop = new Workshop()
const packed = shop.path('packed.glb')

/** Corrections of shapes: what the blendshape of the face in `Workshop.makeFolder` really is. */
const SHAPES = [
  { mesh: 'skin', target: 'browInnerUp', shape: 'cheekPuff' },
  { target: 'Brow_Inner_Up', shape: 'mouthSmile' },
]

async function makeFolder(name: string, shapes: unknown): Promise<string> {
  const folder = await shop.makeFolder(name)
  shop.json(`${name}/wrinkles.json`, { shapes })
  return folder
}

/** Returns a copy of a file with other corrections. */
function withShapes(file: string, shapes: unknown): string {
  const edited = editGlb(readFileSync(file), ({ materials }) => {
    materials[0].extensions[NAME].shapes = shapes
  })
  return shop.write('edited.glb', edited)
}

beforeAll(async () => {
  await shop.run('pack', await makeFolder('face', SHAPES), '-o', packed)
})

describe('shape corrections', () => {
  it.each([
    ['PNG', []],
    ['KTX 2', ['--ktx2']],
  ])('are unpacked from the file, with maps as %s', async (kind, args) => {
    const [file, again, folder] = ['.glb', '-again.glb', ''].map((end) => shop.path(`${kind}${end}`))
    await shop.run('pack', shop.path('face'), '-o', file, ...args)
    expect(shop.warned).toBe('')
    expect(wrinklesIn(file).shapes).toEqual(SHAPES)
    await shop.run('unpack', file, '-o', folder)
    expect(JSON.parse(readFileSync(`${folder}/wrinkles.json`, 'utf8')).shapes).toEqual(SHAPES)
    await shop.run('pack', folder, '-o', again, ...args)
    expect(wrinklesIn(again).shapes).toEqual(SHAPES)
  })

  it('are removed if a set without corrections replaces the set', async () => {
    await shop.run('pack', await makeFolder('none', []), '--face', packed, '-o', shop.path('none.glb'))
    expect(wrinklesIn(shop.path('none.glb'))).not.toHaveProperty('shapes')
    await shop.run('unpack', shop.path('none.glb'), '-o', shop.path('none-again'))
    expect(JSON.parse(readFileSync(shop.path('none-again/wrinkles.json'), 'utf8'))).not.toHaveProperty(
      'shapes',
    )
  })

  it('are refused in a folder if malformed', async () => {
    const folder = await makeFolder('malformed', [{ target: 'a' }, { target: 'b', shape: 'jawOpn' }])
    const message = 'wrinkles.json: shapes[1].shape is unknown, got "jawOpn"'
    await shop.fails(message, 'pack', folder, '-o', shop.path('malformed.glb'))
  })

  it('are skipped in a file if malformed', async () => {
    const file = withShapes(packed, [SHAPES[0], { target: 7 }, { target: 'x', shape: 'joy' }])
    await shop.run('validate', file)
    expect(process.exitCode).toBeUndefined()
    expect(shop.printed).toMatch(/shapes\[1\]\.target must be text, .* \(1 more malformed\)/)
    await shop.run('unpack', file, '-o', shop.path('rest'))
    expect(shop.warned).toContain('furrow unpack: a correction is left out: shapes[1].target must be text')
    expect(JSON.parse(readFileSync(shop.path('rest/wrinkles.json'), 'utf8')).shapes).toEqual([SHAPES[0]])
  })

  it('are kept, with a warning, if their blendshapes are missing', async () => {
    const shapes = [
      { mesh: 'body', target: 'browInnerUp' },
      { target: 'other', shape: 'jawOpen' },
    ]
    await shop.run('pack', await makeFolder('missing', shapes), '-o', shop.path('missing.glb'))
    for (const what of ['blendshape "browInnerUp" of mesh "body"', 'blendshape "other"'])
      expect(shop.warned).toContain(`furrow pack: ${what} does not exist; the reference to it is kept`)
    expect(wrinklesIn(shop.path('missing.glb')).shapes).toEqual(shapes)
    await shop.run('validate', shop.path('missing.glb'))
    expect(shop.printed).toContain('blendshape "other" does not exist')
  })

  it.each([
    ['its index', '0', undefined, true],
    ['an index that is the name of another mesh', '0', '0', false],
  ])('name a mesh by %s', async (_, mesh, other, isFound) => {
    const file = withShapes(packed, [{ mesh, target: 'browInnerUp', shape: 'cheekPuff' }])
    const named = editGlb(readFileSync(file), ({ meshes }) => {
      meshes[1].name = other
    })
    const { shapes } = JSON.parse(await shop.output('inspect', shop.write('named.glb', named), '--json'))
    expect(shapes[0].by === 'correction').toBe(isFound)
  })

  it('are shown by furrow inspect, which uses the first of two for one blendshape', async () => {
    await shop.run('inspect', packed)
    expect(shop.printed).toMatch(/^browInnerUp +cheekPuff +1\.00 +correction$/m)
    await shop.run('inspect', withShapes(packed, [{ target: 'browInnerUp' }]))
    expect(shop.printed).toMatch(/^browInnerUp +none +correction$/m)
    const { shapes } = JSON.parse(await shop.output('inspect', packed, '--json'))
    expect(shapes).toEqual([
      { blendshape: 'browInnerUp', shape: 'cheekPuff', confidence: 1, by: 'correction' },
    ])
  })
})

describe('furrow auto', () => {
  const NAMES: Record<string, string> = { noseSneerLeft: 'fat', noseSneerRight: 'male' }

  /** Returns the weight of a blendshape in the driver of an area. */
  function weightOf(file: string, area: string, target: string): number {
    const driver = wrinklesIn(file).drivers.find(
      (one: { type: string; area: string }) => one.type === 'morph' && one.area === area,
    )
    return driver.targets.find(({ name }: { name: string }) => name === target)?.weight ?? 0
  }

  it('makes the wrinkles of corrected shapes, and keeps the corrections', async () => {
    const renamed = editGlb(readFileSync(HUMAN), ({ meshes }) => {
      const [{ extras }] = meshes
      extras.targetNames = extras.targetNames.map((name: string) => NAMES[name] ?? name)
    })
    const plain = shop.write('renamed.glb', renamed)
    const shapes = [
      { mesh: 'skin', target: 'fat', shape: 'noseSneerLeft' },
      { mesh: 'skin', target: 'male', shape: 'noseSneerRight' },
      { target: 'mouthPucker' },
    ]
    const [before, after] = [shop.path('before.glb'), shop.path('after.glb')]
    const options = ['--size', '512', '--replace']
    await shop.run('auto', plain, '-o', before, ...options)
    await shop.run('auto', withShapes(plain, shapes), '-o', after, ...options)
    const areasOf = (file: string) => wrinklesIn(file).areas.map(({ name }: { name: string }) => name)
    expect(areasOf(before)).not.toContain('noseLeft')
    expect(areasOf(after)).toEqual(expect.arrayContaining(['noseLeft', 'noseRight']))
    expect(weightOf(after, 'noseLeft', 'fat')).toBeGreaterThan(0.5)
    // Without its shape, the blendshape does not drive the lines that its shape causes.
    const [driving, corrected] = [before, after].map((file) => weightOf(file, 'lowerLip', 'mouthPucker'))
    expect(driving).toBeGreaterThan(0.5)
    expect(corrected).toBe(0)
    expect(wrinklesIn(after).shapes).toEqual(shapes)
    await shop.run('validate', after)
    expect(process.exitCode).toBeUndefined()
  })
})
