import { readdirSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import Ajv2020, { type ValidateFunction } from 'ajv/dist/2020.js'
import { parseStrokes } from 'furrow/author'
import { DRIVER_TYPES, parseCorrections, parseWrinkleMaps } from 'furrow/internal'
import { beforeAll, describe, expect, it } from 'vitest'
import { jsonOf } from '../../glb.ts'
import { Workshop } from '../cli/workshop.ts'
import { compareWithParser, MUTATED } from './mutations.ts'
import { createIO, createSample, NAME } from './sample.ts'

const DOCS = fileURLToPath(new URL('../../../docs', import.meta.url))
const page = readFileSync(`${DOCS}/FURROW_wrinkle_maps.md`, 'utf8')
const human = fileURLToPath(new URL('../../../faces/human', import.meta.url))
const shop = new Workshop()

type Schema = Record<string, { default?: unknown }>

const schemas = new Map(
  readdirSync(`${DOCS}/schema`).map((file) => [
    file,
    JSON.parse(readFileSync(`${DOCS}/schema/${file}`, 'utf8')),
  ]),
)
let validate: ValidateFunction

beforeAll(() => {
  const ajv = new Ajv2020({ schemas: [...schemas.values()] })
  validate = ajv.getSchema(`material.${NAME}.schema.json`)!
})

/** Returns the rows of the table below a heading of the page. */
function tableOf(heading: string): { name: string; type: string; required: string }[] {
  const [, section = ''] = page.split(`\n### ${heading}\n`)
  const rows = section.split(/\n##/)[0].matchAll(/^\| \*\*(\w+)\*\* \| `(.+?)` \| .+ \| (.+) \|$/gm)
  return [...rows].map(([, name, type, required]) => ({ name, type, required }))
}

describe('the page of the extension', () => {
  it.each([
    ['FURROW\\_wrinkle\\_maps', `material.${NAME}`],
    ['layer', `${NAME}.layer`],
    ['area', `${NAME}.area`],
    ['shape', `${NAME}.shape`],
    ['driver', `${NAME}.driver`],
    ...DRIVER_TYPES.map((type) => [`driver of type \`${type}\``, `${NAME}.driver.${type}`]),
    ['link', `${NAME}.driver.morph`],
    ['textureInfo', 'textureInfo'],
  ])('lists the properties of its schema under "%s", with their defaults', (heading, file) => {
    const schema = schemas.get(`${file}.schema.json`)
    const { properties, required } = (heading === 'link' ? schema.properties.targets.items : schema) as {
      properties: Schema
      required: string[]
    }
    const rows = tableOf(heading)
    expect(rows.map(({ name }) => name)).toEqual(Object.keys(properties))
    for (const row of rows) {
      const { default: defaultValue } = properties[row.name]
      const text = JSON.stringify(defaultValue, null, 1)?.replaceAll(/\n */g, '').replaceAll(',', ', ')
      const expected = text === undefined ? 'no' : `no, default: \`${text}\``
      expect(row.required, row.name).toBe(required.includes(row.name) ? 'yes' : expected)
    }
  })

  it('states the limits that the schema has', () => {
    const [layers, areas, drivers] = tableOf('FURROW\\_wrinkle\\_maps').map(({ type }) => type)
    expect([layers, areas, drivers]).toEqual(['layer [1-4]', 'area [1-256]', 'driver [0-4096]'])
    const { properties } = schemas.get(`material.${NAME}.schema.json`)
    expect([properties.layers.maxItems, properties.areas.maxItems]).toEqual([4, 256])
    expect(properties.drivers.maxItems).toBe(4096)
    expect(tableOf('FURROW\\_wrinkle\\_maps').at(-1)!.type).toBe(`shape [0-${properties.shapes.maxItems}]`)
  })

  it('has an example that the schema and the parser accept', () => {
    const [, example] = /```json\n([\s\S]+?)```/.exec(page)!
    const maps = JSON.parse(example).materials[0].extensions[NAME]
    expect(validate(maps), JSON.stringify(validate.errors)).toBe(true)
    expect(parseWrinkleMaps(maps, 11).areas).toHaveLength(3)
  })
})

describe('the schema', () => {
  it('accepts the packed human face', async () => {
    await shop.run('pack', human, '--face', `${human}.glb`, '-o', shop.path('human.glb'))
    const json = jsonOf(readFileSync(shop.path('human.glb')))
    const maps = json.materials[0].extensions[NAME]
    expect(validate(maps), JSON.stringify(validate.errors)).toBe(true)
    expect(maps.areas).toHaveLength(12)
  })

  it('accepts everything that the parsers accept, and refuses most of what they refuse', async () => {
    const { json } = await createIO().writeJSON(await createSample())
    const extension = json.materials![0].extensions![NAME]
    const { accepted, missed } = compareWithParser(
      extension,
      validate,
      (maps) => {
        parseWrinkleMaps(maps, 10)
        if (maps.strokes !== undefined) parseStrokes(maps.strokes)
        parseCorrections(maps.shapes, 'test')
      },
      4,
    )
    expect(accepted).toBeGreaterThan(MUTATED / 100)
    // The schema accepts some invalid documents, because it cannot check names, indices and curves.
    expect(missed).toBeLessThan(0.25)
  })
})
