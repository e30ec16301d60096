import { existsSync, readdirSync, statSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { expect, it } from 'vitest'
import { exampleNames, GROUPS, readExample } from '../../scripts/lib/examples.mjs'
import { EXAMPLES } from '../pages/examples.ts'

const FOLDER = fileURLToPath(new URL('../../examples/', import.meta.url))
const names = exampleNames()

it('the folder of examples and the table of test/pages/examples.ts have the same pages', () => {
  expect([...new Set(EXAMPLES.map(({ page }) => page))].sort()).toEqual(names)
})

it('every example that the test of all examples skips names an existing test file', () => {
  for (const { test } of EXAMPLES) {
    if (test) expect(existsSync(fileURLToPath(new URL(`../pages/${test}`, import.meta.url)))).toBe(true)
  }
})

it.each(names)('%s has a title, a description of one sentence, keywords and a group', (name) => {
  const { title, description, keywords, group } = readExample(name)
  expect(title).toMatch(/^[A-Z]/)
  expect(description).toMatch(/^[A-Z][^.]*\.$/)
  expect(keywords.split(', ').length).toBeGreaterThanOrEqual(3)
  expect(GROUPS).toContain(group)
})

it.each(names)('%s has under 80 lines', (name) => {
  expect(readExample(name).source.trimEnd().split('\n').length).toBeLessThan(80)
})

it('every example has a picture of at most 30 kB, made by npm run figures -- examples', () => {
  expect(readdirSync(`${FOLDER}pictures`).sort()).toEqual(names.map((name) => `${name}.jpg`).sort())
  for (const name of names) expect(statSync(`${FOLDER}pictures/${name}.jpg`).size, name).toBeLessThan(30e3)
})
