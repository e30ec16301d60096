import { readFileSync } from 'node:fs'
import Ajv2020 from 'ajv/dist/2020.js'
import { parseStrokes } from 'furrow/author'
import { STROKE_DEFAULTS } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { compareWithParser, MUTATED } from '../gltf/mutations.ts'
import { STROKES } from '../gltf/sample.ts'

const page = readFileSync('docs/strokes-format.md', 'utf8')
const schema = JSON.parse(readFileSync('docs/schema/strokes.schema.json', 'utf8'))
const validate = new Ajv2020().compile(schema)

/** Reads the fields and their defaults from the table below a heading of the page. A table with two columns has no defaults. */
function tableOf(heading: string): [name: string, usual: string | undefined][] {
  const [, section] = page.split(`\n### ${heading}\n`)
  const rows = section.split(/\n##/)[0].matchAll(/^\| `(\w+)` +\| (.*?) +\|(?: .*\|)?$/gm)
  return [...rows].map(([, name, usual]) => [name, usual.trim()])
}

describe('the schema of strokes documents', () => {
  it.each([
    ['The document', schema],
    ['A stroke', schema.$defs.stroke],
    ['Furrows', schema.properties.furrows],
    ['A region of furrows', schema.$defs.furrowRegion],
    ['An area', schema.$defs.area],
  ])('has the fields of the page under "%s"', (heading, { properties }) => {
    expect(tableOf(heading).map(([name]) => name)).toEqual(Object.keys(properties))
  })

  it('has the defaults of the page and of the parser', () => {
    const stated = tableOf('A stroke').filter(([, usual]) => usual !== '')
    const { properties } = schema.$defs.stroke
    for (const [name, usual] of stated) {
      expect(usual, name).toContain(JSON.stringify(properties[name].default))
      const [value] = [STROKE_DEFAULTS[name as keyof typeof STROKE_DEFAULTS]].flat()
      expect(value, name).toBe(properties[name].default)
    }
    expect(stated.map(([name]) => name).sort()).toEqual(Object.keys(STROKE_DEFAULTS).sort())
  })

  it('accepts the example of the page, and the shipped documents', () => {
    const [, example] = /```json\n([\s\S]+?)```/.exec(page)!
    const shipped = ['human/strokes', 'human-2/strokes', 'human/drawn'].map((name) =>
      readFileSync(`faces/${name}.json`, 'utf8'),
    )
    for (const text of [example, ...shipped]) {
      expect(validate(JSON.parse(text)), JSON.stringify(validate.errors)).toBe(true)
      parseStrokes(JSON.parse(text))
    }
  })

  it('accepts everything that the parser accepts, and refuses most of what the parser refuses', () => {
    const { accepted, missed } = compareWithParser(STROKES, validate, parseStrokes, 6)
    expect(accepted).toBeGreaterThan(MUTATED / 100)
    // The schema accepts some invalid documents, because it cannot check groups, file names and the number of points of Bezier curves.
    expect(missed).toBeLessThan(0.25)
  })
})
