import { existsSync, readFileSync } from 'node:fs'
import sharp from 'sharp'
import { beforeAll, describe, expect, it } from 'vitest'
import { editGlb, jsonOf } from '../../glb.ts'
import { noise } from '../../noise.ts'
import { Workshop, wrinklesIn } from './workshop.ts'

const NAME = 'FURROW_wrinkle_maps'
const shop = new Workshop()
const packed = shop.path('packed.glb')

/** Strokes document for the layers that `Workshop.makeFolder` makes. */
const STROKES = {
  version: 1,
  scale: 100,
  size: 64,
  strokes: [
    {
      layer: 'age',
      group: 'brow',
      curve: 'spline',
      points: [
        [0.123456789, 0.5],
        [0.2, 0.8],
      ],
      width: 5,
      depth: 1,
      depths: [1, 0.5, 1],
    },
    {
      layer: 'expression',
      points: [
        [0.1, 0.7],
        [0.2, 0.75],
        [0.3, 0.7],
      ],
      width: 4,
      depth: 0.5,
      taper: [0, 0.2],
    },
  ],
  areas: [{ name: 'brow', shapes: [{ group: 'brow', radius: 6, feather: 8 }] }],
}

const read = (name: string) => JSON.parse(readFileSync(shop.path(name), 'utf8'))

/** Makes a folder with a strokes document. */
async function makeFolder(name: string, strokes: unknown = STROKES): Promise<string> {
  const folder = await shop.makeFolder(name)
  shop.json(`${name}/strokes.json`, strokes)
  return folder
}

/** Writes a copy of the packed face with other strokes, and returns its path. */
function withStrokes(strokes: unknown): string {
  const edited = editGlb(readFileSync(packed), ({ materials }) => {
    materials[0].extensions[NAME].strokes = strokes
  })
  return shop.write('other.glb', edited)
}

beforeAll(async () => {
  await shop.run('pack', await makeFolder('face'), '-o', packed)
})

describe('the strokes of a folder', () => {
  it.each([
    ['PNG', []],
    ['KTX 2', ['--ktx2']],
  ])('are unpacked from the file, with maps as %s', async (kind, args) => {
    const [file, again] = ['', '-again'].map((end) => shop.path(`${kind}${end}.glb`))
    const folder = `${kind}-unpacked`
    await shop.run('pack', shop.path('face'), '-o', file, '--json', ...args)
    expect(JSON.parse(shop.printed)).toMatchObject({ strokes: 2 })
    expect(wrinklesIn(file).strokes).toEqual(STROKES)
    await shop.run('unpack', file, '-o', shop.path(folder))
    expect(read(`${folder}/strokes.json`)).toEqual(STROKES)
    expect(read(`${folder}/wrinkles.json`).strokes).toBe('strokes.json')
    expect(JSON.stringify(jsonOf(readFileSync(shop.path(`${folder}/face.glb`))))).not.toContain('spline')
    await shop.run('pack', shop.path(folder), '-o', again, ...args)
    expect(JSON.stringify(wrinklesIn(again).strokes)).toBe(JSON.stringify(STROKES))
  })

  it('are unpacked with one line per stroke, and furrow strokes can draw them', async () => {
    await shop.run('unpack', packed, '-o', shop.path('lines'))
    const text = readFileSync(shop.path('lines/strokes.json'), 'utf8')
    for (const stroke of STROKES.strokes)
      expect(text.split('\n')).toContainEqual(expect.stringContaining(JSON.stringify(stroke)))
    const height = shop.path('height.png')
    const strokes = [shop.path('lines/strokes.json'), '--face', packed, '-o', height, '--layer', 'age']
    await shop.run('strokes', ...strokes)
    const { channels } = await sharp(height).stats()
    expect(channels[0].min).toBeLessThan(channels[0].max)
  })

  it('may be in a file with another name, which wrinkles.json states', async () => {
    const folder = await shop.makeFolder('named')
    shop.json('named/strokes.json', { not: 'read' })
    shop.json('named/lines/a b.json', STROKES)
    shop.json('named/wrinkles.json', { strokes: 'lines/a%20b.json' })
    await shop.run('pack', folder, '-o', shop.path('named.glb'))
    expect(wrinklesIn(shop.path('named.glb')).strokes).toEqual(STROKES)
  })

  it('need not name their layer if there is only one', async () => {
    shop.write('single/face.glb', readFileSync(shop.path('face/face.glb')))
    shop.write('single/layers/only/normal.png', await noise(1))
    shop.write('single/areas/brow.png', readFileSync(shop.path('face/areas/brow.png')))
    const strokes = { version: 1, strokes: STROKES.strokes.map(({ layer: _, ...stroke }) => stroke) }
    shop.json('single/strokes.json', strokes)
    await shop.run('pack', shop.path('single'), '-o', shop.path('single.glb'))
    expect(wrinklesIn(shop.path('single.glb')).strokes).toEqual(strokes)
  })

  it('replace those of the face, and are removed if a set without strokes replaces the set', async () => {
    const strokes = { ...STROKES, strokes: STROKES.strokes.slice(1), areas: undefined }
    await shop.run('pack', await makeFolder('fewer', strokes), '--face', packed, '-o', shop.path('fewer.glb'))
    expect(wrinklesIn(shop.path('fewer.glb')).strokes.strokes).toHaveLength(1)
    await shop.run('pack', await shop.makeFolder('none'), '--face', packed, '-o', shop.path('none.glb'))
    expect(wrinklesIn(shop.path('none.glb'))).not.toHaveProperty('strokes')
    await shop.run('unpack', shop.path('none.glb'), '-o', shop.path('none-unpacked'))
    expect(existsSync(shop.path('none-unpacked/strokes.json'))).toBe(false)
    expect(read('none-unpacked/wrinkles.json')).not.toHaveProperty('strokes')
  })

  const [first, second] = STROKES.strokes
  const strokes = (...list: object[]) => JSON.stringify({ version: 1, strokes: list })

  it.each<[string, string, string]>([
    [
      'an unknown layer',
      strokes(first, { ...second, layer: 'Expresion' }),
      'strokes.json: strokes[1] is on an unknown layer, got "Expresion", allowed: age, expression; did you mean "expression"?',
    ],
    [
      'no layer, of two',
      strokes(first, { ...second, layer: undefined }),
      'strokes.json: strokes[1] names no layer, allowed: age, expression; name one of the layers',
    ],
    [
      'a wrong number',
      strokes({ ...first, width: 0 }),
      'strokes.json: strokes[0].width is out of range, got 0',
    ],
    ['no JSON', '{', 'cannot read the strokes strokes.json ('],
    ['too deep', `${'['.repeat(200)}${']'.repeat(200)}`, 'its JSON is more than 128 levels deep'],
    ['too large', ' '.repeat(2 ** 22 + 1), 'strokes.json is too large, got "5 MiB", allowed: 4 MiB'],
  ])('are refused in one line: %s', async (_, text, message) => {
    const folder = await shop.makeFolder('wrong')
    shop.write('wrong/strokes.json', text)
    await shop.fails(message, 'pack', folder, '-o', shop.path('wrong.glb'))
  })
})

describe('the strokes of a file', () => {
  it('are counted by inspect', async () => {
    await shop.run('inspect', packed)
    expect(shop.printed.split('\n')).toContain('strokes: 2')
    const report = JSON.parse(await shop.output('inspect', packed, '--json'))
    expect(report.strokes).toEqual({ count: 2, bytes: JSON.stringify(STROKES).length })
  })

  it.each<[string, unknown, string]>([
    ['malformed', { ...STROKES, strokes: [] }, 'strokes has the wrong number of items, got 0'],
    ['of another type', 'lines', 'the document must be an object, got "lines"'],
    ['null', null, 'the document must be an object, got null'],
    [
      'on an unknown layer',
      { version: 1, strokes: [{ ...STROKES.strokes[0], layer: 'x' }] },
      'strokes[0] is on an unknown layer, got "x"',
    ],
  ])('are skipped if they are %s, and the wrinkles stay', async (kind, strokes, problem) => {
    const file = withStrokes(strokes)
    await shop.run('validate', file)
    const [warning, ...rest] = shop.printed.trimEnd().split('\n')
    expect(warning).toContain(`warning: /materials/0/extensions/${NAME}: ${NAME}: strokes: ${problem}`)
    expect(warning).toMatch(/ \(STROKES\)$/)
    expect(rest).toEqual([`${file}: 0 errors, 1 warning`])
    expect(process.exitCode).toBeUndefined()
    const folder = `unpacked ${kind}`
    await shop.run('unpack', file, '-o', shop.path(folder))
    expect(shop.warned).toContain(`furrow unpack: the strokes are left out: ${problem}`)
    expect(existsSync(shop.path(`${folder}/strokes.json`))).toBe(false)
    expect(read(`${folder}/wrinkles.json`)).not.toHaveProperty('strokes')
    const report = JSON.parse(await shop.output('inspect', file, '--json'))
    expect(report.strokes).toEqual({ count: 0, bytes: 0 })
  })
})
