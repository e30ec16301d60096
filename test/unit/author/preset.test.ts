import { readFileSync } from 'node:fs'
import Ajv2020 from 'ajv/dist/2020.js'
import { FurrowError } from 'furrow'
import { AUTO_DEFAULTS, AUTO_REGIONS, type AutoPreset, DENSE_REGIONS, parseAutoPreset } from 'furrow/author'
import { AUTO_SIDES } from 'furrow/internal'
import { describe, expect, it, test } from 'vitest'
import { compareWithParser, MUTATED } from '../gltf/mutations.ts'

const PRESET = {
  age: 60,
  strength: 1.2,
  symmetry: 0.3,
  seed: 7,
  seeds: { chin: 3 },
  strengths: { foreheadInner: 1.6, crowsFeetLeft: 0, bag: 0.5 },
  densities: { foreheadInner: 1.5, upperLip: 0.5 },
  regions: ['foreheadInner', 'crowsFeet', 'upperLip', 'bag'],
} as const satisfies AutoPreset

const schema = JSON.parse(readFileSync('docs/schema/preset.schema.json', 'utf8'))
const validate = new Ajv2020().compile(schema)

test('a preset is read as it was written', () => {
  const text = JSON.stringify({ version: 1, ...PRESET })
  expect(parseAutoPreset(JSON.parse(text))).toEqual(PRESET)
  expect(parseAutoPreset({ version: 1 })).toEqual({})
})

test.each([
  ['no version', {}, 'parseAutoPreset: unknown version of the preset, got nothing, allowed: 1'],
  ['a later version', { version: 2 }, 'unknown version of the preset, got 2, allowed: 1'],
  ['no object', [], 'the preset must be an object'],
  ['null', null, 'the preset must be an object'],
  ['strokes', { version: 1, strokes: [] }, 'unknown field, got "strokes", allowed: version, age'],
  ['text for a number', { version: 1, age: '60' }, 'invalid age, got "60", allowed: a number, 20 to 80'],
  ['an infinite number', JSON.parse('{"version":1,"age":1e999}'), 'invalid age, got Infinity'],
  ['a list for values of regions', { version: 1, seeds: [1] }, 'seeds must be an object'],
  ['null for values of regions', { version: 1, strengths: null }, 'strengths must be an object'],
  ['text for a list', { version: 1, regions: 'chin' }, 'regions must be an array'],
  ['a number for a region', { version: 1, regions: [1] }, 'unknown region, got 1'],
  ['an unknown region', { version: 1, strengths: { crowsFoot: 1 } }, 'did you mean "crowsFeet"?'],
  ['half of a region in the middle', { version: 1, strengths: { chinLeft: 1 } }, 'got "chinLeft"'],
  [
    'a strength out of range',
    { version: 1, strengths: { chin: 3 } },
    'invalid strength, got 3, allowed: a number, 0 to 2',
  ],
  [
    'a number of lines where it is fixed',
    { version: 1, densities: { nasolabial: 2 } },
    'got "nasolabial", allowed: foreheadInner, nose',
  ],
  ['a number of lines out of range', { version: 1, densities: { nose: 0 } }, 'a number, 0.5 to 2'],
])('refuses %s', (_, json, message) => {
  expect(() => parseAutoPreset(json)).toThrow(message)
})

describe('the schema of presets', () => {
  it('has the regions and the defaults of the options', () => {
    const { properties, $defs } = schema
    expect($defs.region.enum).toEqual(AUTO_REGIONS)
    expect(properties.strengths.propertyNames.enum).toEqual(AUTO_SIDES)
    expect(properties.densities.propertyNames.enum).toEqual(DENSE_REGIONS)
    for (const name of ['strength', 'symmetry'] as const)
      expect(properties[name].default).toBe(AUTO_DEFAULTS[name])
  })

  it('accepts what the parser accepts, and refuses what the parser refuses with an error of its own', () => {
    const crashes: unknown[] = []
    const parse = (json: unknown) => {
      try {
        return parseAutoPreset(json)
      } catch (error) {
        if (!(error instanceof FurrowError)) crashes.push(error)
        throw error
      }
    }
    const { accepted, missed } = compareWithParser({ version: 1, ...PRESET }, validate, parse, 8)
    expect(crashes).toEqual([])
    expect(accepted).toBeGreaterThan(MUTATED / 100)
    expect(missed).toBe(0)
  })
})
