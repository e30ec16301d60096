// Tests that the entry points of the packed `furrow` share their common code, and that a page requests few files.

import { cp, mkdir, readFile, symlink, writeFile } from 'node:fs/promises'
import { dirname, join, relative } from 'node:path'
import { afterAll, beforeAll, expect, inject, it } from 'vitest'
import { importsIn } from '../../scripts/lib/imports.mjs'
import { ROOT, remove, run, temporaryFolder } from './npm.ts'

/** For each entry point, a function that throws a FurrowError, given the module. */
const ERRORS = {
  furrow: '({ parseWrinkleSetDocument }) => parseWrinkleSetDocument({ version: 2 })',
  'furrow/three': '({ addDrivers }) => addDrivers(null, [])',
  'furrow/webgpu': '({ addDrivers }) => addDrivers(null, [])',
  'furrow/inspector': '({ WrinkleInspector }) => new WrinkleInspector(null)',
  'furrow/react': '({ extendLoader }) => extendLoader(null)',
  'furrow/react/webgpu': '({ extendLoader }) => extendLoader(null)',
  'furrow/babylon': '({ Wrinkles }) => new Wrinkles(null)',
  'furrow/author': '({ parseStrokes }) => parseStrokes({ version: 99 })',
  'furrow/live': '({ connectLive }) => connectLive("http://localhost", () => {})',
  'furrow/gltf': `async ({ FurrowWrinkleMaps }) => {
    const document = new Document()
    const maps = document.createExtension(FurrowWrinkleMaps)
    const wrinkles = maps.createMaterialWrinkles().addLayer(maps.createLayer('without a texture'))
    document.createMaterial().setExtension('FURROW_wrinkle_maps', wrinkles)
    await new WebIO().registerExtensions([FurrowWrinkleMaps]).writeBinary(document)
  }`,
  'furrow/auto': '({ autoWrinklesInWorker }) => autoWrinklesInWorker({}, { age: -1 })',
}

const ENTRIES = Object.keys(ERRORS)
const PAIRS = ENTRIES.flatMap((a, i) => ENTRIES.slice(i + 1).map((b) => [a, b]))

/** Maximum number of files that a page without a bundler may request for one entry point. */
const MAX_REQUESTS = 6

let app: string
beforeAll(async () => {
  app = await temporaryFolder()
  const modules = join(app, 'node_modules')
  await mkdir(modules)
  await run(app, 'tar', '-xzf', inject('tarballs').furrow)
  await cp(join(app, 'package'), join(modules, 'furrow'), { recursive: true })
  const { peerDependencies } = JSON.parse(await readFile(join(modules, 'furrow/package.json'), 'utf8'))
  for (const peer of Object.keys(peerDependencies)) {
    await mkdir(dirname(join(modules, peer)), { recursive: true })
    await symlink(join(ROOT, 'node_modules', peer), join(modules, peer), 'junction')
  }
})
afterAll(() => remove(app))

it('all entry points export errors of one class, and those of three.js share one wrinklesOf', async () => {
  const script = `
    import { Document, WebIO } from '@gltf-transform/core'
    const errors = {}, finders = {}
    for (const [entry, fail] of [${Object.entries(ERRORS).map(([entry, fail]) => `['${entry}', ${fail}]`)}]) {
      const module = await import(entry)
      if (/three|webgpu/.test(entry)) finders[entry] = module.wrinklesOf
      errors[entry] = await (async () => fail(module))().then(() => null, (error) => error)
    }
    const { FurrowError } = await import('furrow')
    const same = {}
    for (const [a, b] of ${JSON.stringify(PAIRS)}) {
      const classes = [errors[a]?.constructor, errors[b]?.constructor]
      same[a + ' ' + b] = classes.every((one) => one === FurrowError)
    }
    console.log(JSON.stringify({ same, isOne: finders['furrow/three'] === finders['furrow/webgpu'] }))`
  await writeFile(join(app, 'pairs.mjs'), script)
  const { same, isOne } = JSON.parse(await run(app, process.execPath, '--no-deprecation', 'pairs.mjs'))
  expect(same).toEqual(Object.fromEntries(PAIRS.map((pair) => [pair.join(' '), true])))
  expect(isOne).toBe(true)
})

it(`a plain page requests at most ${MAX_REQUESTS} files per entry point, and no other file imports an entry point`, async () => {
  const root = join(app, 'node_modules/furrow')
  const { exports } = JSON.parse(await readFile(join(root, 'package.json'), 'utf8'))
  const entries = Object.values<{ default?: string }>(exports).flatMap((entry) => entry.default ?? [])
  const counts: Record<string, number> = {}
  for (const entry of entries) {
    const files = new Set([join(root, entry)])
    for (const file of files) {
      for (const { specifier, isDynamic } of importsIn(file, await readFile(file, 'utf8'))) {
        // Skips dynamic imports, which a page requests later or not at all.
        if (specifier.startsWith('.') && !isDynamic) files.add(join(dirname(file), specifier))
      }
    }
    counts[entry] = files.size
    const imported = [...files].slice(1).map((file) => `./${relative(root, file)}`)
    expect(imported.filter((file) => entries.includes(file))).toEqual([])
  }
  expect(Object.keys(counts)).toHaveLength(ENTRIES.length)
  for (const [entry, count] of Object.entries(counts)) expect(count, entry).toBeLessThanOrEqual(MAX_REQUESTS)
})
