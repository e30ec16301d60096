import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath, pathToFileURL } from 'node:url'
import { afterAll, beforeAll, expect, test } from 'vitest'
import { editGlb } from '../glb.ts'
import { openPage, useBrowser } from './browser.ts'
import { type CommandResult, runFurrow } from './run-furrow.ts'

/** Blendshapes that keep their names, which suffice to recognise the rig and to play one expression. */
const KEPT_NAMES = /^(eyeBlink|mouthSmileLeft|browDown|browInnerUp)/

const folder = mkdtempSync(join(tmpdir(), 'furrow-report-'))
const browser = useBrowser()
let result: CommandResult

interface Json {
  meshes: { extras?: { targetNames?: string[] } }[]
}

beforeAll(async () => {
  const face = fileURLToPath(new URL('../../faces/human.glb', import.meta.url))
  const bytes = editGlb(readFileSync(face), ({ meshes }: Json) => {
    for (const { extras } of meshes) {
      if (extras?.targetNames)
        extras.targetNames = extras.targetNames.map((name, i) => (KEPT_NAMES.test(name) ? name : `own ${i}`))
    }
  })
  writeFileSync(join(folder, 'face.glb'), bytes)
  const options = ['--size', '512', '--replace', '--report', join(folder, 'report')]
  result = await runFurrow(
    folder,
    {},
    'auto',
    join(folder, 'face.glb'),
    '-o',
    join(folder, 'out.glb'),
    ...options,
  )
})

afterAll(async () => {
  rmSync(folder, { recursive: true })
})

test('furrow auto --report prints only its result', () => {
  expect(result.stderr).toBe('')
  expect(result.code).toBe(0)
  expect(result.stdout).toContain('index.html: the report')
})

test.each([
  [1280, 800],
  [390, 844],
])('the report fits into %d x %d', async (width, height) => {
  const { page, complaints } = await openPage(browser(), { viewport: { width, height } })
  await page.goto(pathToFileURL(join(folder, 'report/index.html')).href)
  const content = await page.evaluate(() => ({
    scrollWidth: document.documentElement.scrollWidth,
    images: [...document.images].map(({ naturalWidth, width, alt }) => ({ naturalWidth, width, alt })),
    names: [...document.querySelectorAll('.pairs figcaption > b')].map(({ textContent }) => textContent),
    headings: [...document.querySelectorAll('h2')].length,
  }))
  expect(complaints).toEqual([])
  expect(content.scrollWidth).toBe(width)
  expect(content.headings).toBe(5)
  expect(content.names).toEqual(['Frown'])
  for (const image of content.images) {
    expect(image.naturalWidth).toBeGreaterThan(0)
    expect(image.width).toBeGreaterThan(80)
    expect(image.alt).not.toBe('')
  }
  await page.close()
})

test('the pictures before and after differ', () => {
  const [before, after] = ['before', 'after'].map((name) =>
    readFileSync(join(folder, `report/${name}-1.webp`)),
  )
  expect(before.equals(after)).toBe(false)
})
