import { existsSync, readFileSync } from 'node:fs'
import sharp from 'sharp'
import { beforeAll, describe, expect, it } from 'vitest'
import { inspectCommand } from '../../../packages/cli/src/commands/inspect.ts'
import { packCommand } from '../../../packages/cli/src/commands/pack.ts'
import { strokesCommand } from '../../../packages/cli/src/commands/strokes.ts'
import { unpackCommand } from '../../../packages/cli/src/commands/unpack.ts'
import { validateCommand } from '../../../packages/cli/src/commands/validate.ts'
import { jsonOf, noise, Workshop, withJson } from './workshop.ts'

const NAME = 'FURROW_wrinkle_maps'
const shop = new Workshop()
const packed = shop.path('packed.glb')

/** Of the layers of `Workshop.makeFolder`. */
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
const extensionOf = (path: string) => jsonOf(readFileSync(path)).materials[0].extensions[NAME]

/** A folder with strokes on its layers. */
async function makeFolder(name: string, strokes: unknown = STROKES): Promise<string> {
  const folder = await shop.makeFolder(name)
  shop.json(`${name}/strokes.json`, strokes)
  return folder
}

/** The packed face with other strokes. */
function withStrokes(strokes: unknown): string {
  const bytes = readFileSync(packed)
  const json = jsonOf(bytes)
  json.materials[0].extensions[NAME].strokes = strokes
  return shop.write('other.glb', withJson(bytes, json))
}

beforeAll(async () => {
  await shop.run(packCommand, await makeFolder('face'), '-o', packed)
})

describe('the strokes of a folder', () => {
  it.each([
    ['PNG', []],
    ['KTX 2', ['--ktx2']],
  ])('come back from the file, with maps as %s', async (kind, args) => {
    const [file, folder, again] = [
      shop.path(`${kind}.glb`),
      `${kind}-unpacked`,
      shop.path(`${kind}-again.glb`),
    ]
    await shop.run(packCommand, shop.path('face'), '-o', file, '--json', ...args)
    expect(JSON.parse(shop.printed)).toMatchObject({ strokes: 2 })
    expect(extensionOf(file).strokes).toEqual(STROKES)
    await shop.run(unpackCommand, file, '-o', shop.path(folder))
    expect(read(`${folder}/strokes.json`)).toEqual(STROKES)
    expect(read(`${folder}/wrinkles.json`).strokes).toBe('strokes.json')
    expect(JSON.stringify(jsonOf(readFileSync(shop.path(`${folder}/face.glb`))))).not.toContain('spline')
    await shop.run(packCommand, shop.path(folder), '-o', again, ...args)
    expect(JSON.stringify(extensionOf(again).strokes)).toBe(JSON.stringify(STROKES))
  })

  it('are a line each, which furrow strokes draws as they are', async () => {
    await shop.run(unpackCommand, packed, '-o', shop.path('lines'))
    const text = readFileSync(shop.path('lines/strokes.json'), 'utf8')
    for (const stroke of STROKES.strokes)
      expect(text.split('\n')).toContainEqual(expect.stringContaining(JSON.stringify(stroke)))
    const height = shop.path('height.png')
    const strokes = [shop.path('lines/strokes.json'), '--face', packed, '-o', height, '--layer', 'age']
    await shop.run(strokesCommand, ...strokes)
    const { channels } = await sharp(height).stats()
    expect(channels[0].min).toBeLessThan(channels[0].max)
  })

  it('may have another name, which wrinkles.json says', async () => {
    const folder = await shop.makeFolder('named')
    shop.json('named/strokes.json', { not: 'read' })
    shop.json('named/lines/a b.json', STROKES)
    shop.json('named/wrinkles.json', { strokes: 'lines/a%20b.json' })
    await shop.run(packCommand, folder, '-o', shop.path('named.glb'))
    expect(extensionOf(shop.path('named.glb')).strokes).toEqual(STROKES)
  })

  it('need not name their layer where there is one', async () => {
    shop.write('single/face.glb', readFileSync(shop.path('face/face.glb')))
    shop.write('single/layers/only/normal.png', await noise(1, 3))
    shop.write('single/areas/brow.png', readFileSync(shop.path('face/areas/brow.png')))
    const strokes = { version: 1, strokes: STROKES.strokes.map(({ layer: _, ...stroke }) => stroke) }
    shop.json('single/strokes.json', strokes)
    await shop.run(packCommand, shop.path('single'), '-o', shop.path('single.glb'))
    expect(extensionOf(shop.path('single.glb')).strokes).toEqual(strokes)
  })

  it('replace those of the face, and are gone with its old wrinkles', async () => {
    const strokes = { ...STROKES, strokes: STROKES.strokes.slice(1), areas: undefined }
    await shop.run(
      packCommand,
      await makeFolder('fewer', strokes),
      '--face',
      packed,
      '-o',
      shop.path('fewer.glb'),
    )
    expect(extensionOf(shop.path('fewer.glb')).strokes.strokes).toHaveLength(1)
    await shop.run(packCommand, await shop.makeFolder('none'), '--face', packed, '-o', shop.path('none.glb'))
    expect(extensionOf(shop.path('none.glb'))).not.toHaveProperty('strokes')
    await shop.run(unpackCommand, shop.path('none.glb'), '-o', shop.path('none-unpacked'))
    expect(existsSync(shop.path('none-unpacked/strokes.json'))).toBe(false)
    expect(read('none-unpacked/wrinkles.json')).not.toHaveProperty('strokes')
  })

  const [first, second] = STROKES.strokes
  it.each<[string, unknown, string]>([
    [
      'an unknown layer',
      { ...STROKES, strokes: [first, { ...second, layer: 'Expresion' }] },
      'strokes.json: strokes[1] is on an unknown layer, got "Expresion", allowed: age, expression; did you mean "expression"?',
    ],
    [
      'no layer, of two',
      { ...STROKES, strokes: [first, { ...second, layer: undefined }] },
      'strokes.json: strokes[1] names no layer, allowed: age, expression; name one of the layers',
    ],
    [
      'a wrong number',
      { ...STROKES, strokes: [{ ...first, width: 0 }] },
      'strokes.json: strokes[0].width is out of range, got 0',
    ],
    ['no document', [], 'strokes.json: the document must be an object'],
    [
      'an unknown field',
      { ...STROKES, extras: {} },
      'strokes.json: the document has an unknown field, got "extras"',
    ],
  ])('are refused in one line: %s', async (_, strokes, message) => {
    const folder = await makeFolder('wrong', strokes)
    const failure = await shop.failure(packCommand, folder, '-o', shop.path('wrong.glb'))
    expect(failure.name).toBe('FurrowError')
    expect(failure.message).toContain(`furrow pack: ${message}`)
    expect(failure.message).not.toContain('\n')
    expect(existsSync(shop.path('wrong.glb'))).toBe(false)
  })

  it.each<[string, () => string | Uint8Array, string]>([
    ['no JSON', () => '{', 'cannot read the strokes strokes.json ('],
    ['too deep', () => `${'['.repeat(200)}${']'.repeat(200)}`, 'its JSON is more than 128 levels deep'],
    ['too large', () => ' '.repeat(2 ** 22 + 1), 'strokes.json is too large, got "5 MiB", allowed: 4 MiB'],
  ])('are refused in one line: %s', async (_, text, message) => {
    const folder = await shop.makeFolder('unreadable')
    shop.write('unreadable/strokes.json', text())
    const failure = await shop.failure(packCommand, folder, '-o', shop.path('wrong.glb'))
    expect(failure.message).toContain(message)
    expect(failure.message).not.toContain('\n')
  })
})

describe('the strokes of a file', () => {
  it('are counted by inspect', async () => {
    await shop.run(inspectCommand, packed)
    expect(shop.printed.split('\n')).toContain('strokes: 2')
    shop.printed = ''
    await shop.run(inspectCommand, packed, '--json')
    expect(JSON.parse(shop.printed).strokes).toEqual({ count: 2, bytes: JSON.stringify(STROKES).length })
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
  ])('cost nothing else where they are %s', async (kind, strokes, problem) => {
    const file = withStrokes(strokes)
    await shop.run(validateCommand, file)
    const [warning, ...rest] = shop.printed.trimEnd().split('\n')
    expect(warning).toContain(`warning: /materials/0/extensions/${NAME}: ${NAME}: strokes: ${problem}`)
    expect(warning).toMatch(/ \(STROKES\)$/)
    expect(rest).toEqual([`${file}: 0 errors, 1 warning`])
    expect(process.exitCode).toBeUndefined()
    const folder = `unpacked ${kind}`
    await shop.run(unpackCommand, file, '-o', shop.path(folder))
    expect(shop.warned).toContain(`furrow unpack: the strokes are left out: ${problem}`)
    expect(existsSync(shop.path(`${folder}/strokes.json`))).toBe(false)
    expect(read(`${folder}/wrinkles.json`)).not.toHaveProperty('strokes')
    shop.printed = ''
    await shop.run(inspectCommand, file, '--json')
    expect(JSON.parse(shop.printed).strokes).toEqual({ count: 0, bytes: 0 })
  })
})
