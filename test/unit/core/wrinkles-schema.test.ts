import { readdirSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import Ajv2020, { type ValidateFunction } from 'ajv/dist/2020.js'
import { parseWrinkleSetDocument, type WrinkleSetDocument } from 'furrow'
import { parseCorrections } from 'furrow/internal'
import { beforeAll, describe, expect, it } from 'vitest'
import { compareWithParser, MUTATED } from '../gltf/mutations.ts'

const ROOT = fileURLToPath(new URL('../../..', import.meta.url))
const read = (path: string) => readFileSync(`${ROOT}/${path}`, 'utf8')
const schemas = readdirSync(`${ROOT}/docs/schema`).map((file) => JSON.parse(read(`docs/schema/${file}`)))
const schema = schemas.find(({ $id }) => $id === 'wrinkles.schema.json')
let validate: ValidateFunction

beforeAll(() => {
  validate = new Ajv2020({ schemas }).getSchema(schema.$id)!
})

/** Document with every field. The test does not compile if the type has a field that is missing here. */
const FULL = {
  version: 1,
  mesh: 'head',
  material: 'skin',
  layers: [
    {
      name: 'expression',
      kind: 'detail',
      normal: 'n.png',
      normalScale: 0.5,
      baseColor: 'c.png',
      roughness: 'r.png',
      occlusion: 'o.png',
      occlusionStrength: 0.5,
      height: 'h.png',
      heightAmplitude: 0.002,
      blood: 'b.png',
      bloodAmplitude: 0.5,
      onset: 's.png',
      onsetStrength: 0.5,
      sculpted: 'm.png',
    } satisfies Required<WrinkleSetDocument['layers'][number]>,
  ],
  areas: [
    {
      name: 'nose',
      image: 'nose.png',
      layer: 'expression',
      combine: 'max',
      convention: 'weight',
      activation: 0.25,
    } satisfies Required<WrinkleSetDocument['areas'][number]>,
  ],
  drivers: [
    { type: 'morph', area: 'nose', targets: [{ name: 'noseSneerLeft', weight: 0.5 }], rule: 'max' },
    { type: 'time', area: 'nose', attack: 0.1 },
  ],
  areaSize: 64,
  strokes: 'lines.json',
  shapes: [
    { mesh: 'head', target: 'key_12', shape: 'browInnerUp' },
    { target: 'Smile', shape: 'mouthSmile' },
    { target: 'fat' },
  ],
} satisfies Required<WrinkleSetDocument>

/** Parses a document as `furrow pack` does. */
function parse(json: unknown): WrinkleSetDocument {
  const document = parseWrinkleSetDocument(json)
  parseCorrections(document.shapes, 'wrinkles.json')
  return document
}

interface Fields {
  properties: Record<string, { default?: unknown }>
  required?: string[]
  dependentRequired?: Record<string, string[]>
}

/** Objects in the document: prefix of the paths of their fields, schema, and example. */
const OBJECTS: [string, Fields, object][] = [
  ['', schema, FULL],
  ['layers[].', schema.$defs.layer, FULL.layers[0]],
  ['areas[].', schema.$defs.area, FULL.areas[0]],
]

/** Reads the tables below a heading of a page. Returns the path of each field with its text in the column of defaults. */
function tableOf(page: string, heading: string): [string, string][] {
  const [, section] = read(page).split(`\n${heading}\n`)
  const rows = section.split(/\n## /)[0].matchAll(/^\| (`.+?`) \| .+ \| (.+) \|$/gm)
  return [...rows].flatMap(([, cell, usual]): [string, string][] => {
    const names = [...cell.matchAll(/`(.+?)`/g)].map(([, name]) => name)
    const [, start = ''] = /^(.+\.)?/.exec(names[0])!
    return names.map((name, i) => [i === 0 ? name : start + name, usual])
  })
}

describe('the schema of wrinkles.json', () => {
  it('has the fields of the documents, with the same required fields and defaults', () => {
    const documented = new Map(tableOf('docs/wrinkles-json.md', '## Fields'))
    const paths = OBJECTS.flatMap(([start, { properties }]) =>
      Object.keys(properties).map((name) => start + name),
    )
    expect([...documented.keys()].sort()).toEqual(paths.sort())
    for (const [start, { properties, required = [], dependentRequired = {} }] of OBJECTS) {
      for (const [name, { default: value }] of Object.entries(properties)) {
        const usual = documented.get(start + name)!
        expect(usual === 'required', usual).toBe(required.includes(name))
        const dependent = Object.values(dependentRequired).flat()
        expect(/^required with/.test(usual), usual).toBe(dependent.includes(name))
        const text = value === undefined ? [] : Array.isArray(value) ? ['none'] : [`${value}`, `\`${value}\``]
        if (text.length > 0) expect(text, start + name).toContain(usual)
      }
    }
  })

  it('has the fields that the parser reads', () => {
    expect(validate(FULL), JSON.stringify(validate.errors)).toBe(true)
    expect(parseWrinkleSetDocument(FULL)).toMatchObject(FULL)
    for (const [start, { properties }, object] of OBJECTS) {
      expect(Object.keys(object).sort(), start).toEqual(Object.keys(properties).sort())
      for (const name of Object.keys(properties)) {
        const spoilt = { ...object, [name]: { no: 'value' } }
        const whole = start === '' ? spoilt : { ...FULL, [start.slice(0, -3)]: [spoilt] }
        expect(validate(whole), start + name).toBe(false)
        expect(() => parse(whole), start + name).toThrow(name)
      }
    }
  })

  it('has shape corrections that are skipped if malformed', () => {
    expect(parseWrinkleSetDocument({ ...FULL, shapes: 'none' }).areas).toHaveLength(1)
  })

  it('accepts the examples of the documentation, and the shipped sets', () => {
    const examples = ['docs/guide.md', 'docs/wrinkles-json.md'].map(
      (page) => /```json\n([\s\S]+?)```/.exec(read(page))![1],
    )
    const sets = ['human', 'human-2'].map((name) => read(`faces/${name}/wrinkles.json`))
    for (const text of [...examples, ...sets]) {
      expect(validate(JSON.parse(text)), JSON.stringify(validate.errors)).toBe(true)
      expect(parseWrinkleSetDocument(JSON.parse(text)).version).toBe(1)
    }
  })

  it('accepts everything that the parser accepts, and refuses most of what the parser refuses', () => {
    const { accepted, missed } = compareWithParser(FULL, validate, parse, 5)
    expect(accepted).toBeGreaterThan(MUTATED / 100)
    // The schema accepts some invalid documents: it cannot check area names, and layers and areas may be missing because a folder has them.
    expect(missed).toBeLessThan(0.25)
  })
})
