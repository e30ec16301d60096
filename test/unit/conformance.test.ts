import { readdirSync, readFileSync, statSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { checkWrinkles, decodeGlb } from 'furrow-files'
import { describe, expect, it } from 'vitest'
import { SAMPLES } from '../../conformance/src/samples.ts'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
const FOLDER = join(ROOT, 'conformance/files')
const MAX_FILE_BYTES = 50_000

const specification = readFileSync(join(ROOT, 'docs/FURROW_wrinkle_maps.md'), 'utf8')
const headings = new Set(
  [...specification.matchAll(/^#+ (.+)$/gm)].map(([, title]) => title.replace(/[\\`]/g, '')),
)

/** Validate is stricter than a loader, which leaves malformed drivers out. */
const FINDINGS = new Set(['malformed-drivers'])

it('there are samples of distinct names, at least 30', () => {
  expect(SAMPLES.length).toBeGreaterThanOrEqual(30)
  expect(new Set(SAMPLES.map(({ name }) => name)).size).toBe(SAMPLES.length)
})

it('the folder holds the files of the samples, none above 50 kB', () => {
  const files = readdirSync(FOLDER)
  expect(files.filter((name) => name.endsWith('.glb')).sort()).toEqual(
    SAMPLES.map(({ name }) => `${name}.glb`).sort(),
  )
  for (const name of files) expect(statSync(join(FOLDER, name)).size, name).toBeLessThan(MAX_FILE_BYTES)
})

describe.each(SAMPLES)('$name', (sample) => {
  it('is of a rule under a heading of the specification', () => {
    expect(headings).toContain(sample.section)
  })

  it('has all areas in each pose', () => {
    const names = sample.file.areas.map(({ name }) => name)
    for (const { activations } of sample.poses)
      expect(Object.keys(activations).sort()).toEqual([...names].sort())
  })

  it('is refused by validate where a loader must refuse it', async () => {
    const path = join(FOLDER, `${sample.name}.glb`)
    const findings = await checkWrinkles(decodeGlb(readFileSync(path), path, 'test'))
    const errors = findings.filter(({ severity }) => severity === 'error')
    expect(errors.length > 0).toBe(sample.poses.length === 0 || FINDINGS.has(sample.name))
  })
})
