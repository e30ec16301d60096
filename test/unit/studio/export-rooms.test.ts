import { readdirSync, readFileSync } from 'node:fs'
import { dirname, join, relative, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { expect, it } from 'vitest'

const ROOT = fileURLToPath(new URL('../../../', import.meta.url))
const EXPORT = join(ROOT, 'studio/src/export')
const FILES = join(ROOT, 'packages/files')

/** Modules with a version for Node and one for browsers, by import name. */
const PLATFORMS: Record<string, { node: string; default: string }> = JSON.parse(
  readFileSync(join(FILES, 'package.json'), 'utf8'),
).imports

/** Packages that run in browsers, as their documentation says and test/gpu/export.test.ts shows. */
const PORTABLE = [
  '@bokuweb/zstd-wasm',
  '@gltf-transform/core',
  '@gltf-transform/extensions',
  'comlink',
  'draco3d',
  'fast-png',
  'furrow',
  'gltf-validator',
  'ktx-parse',
  'ktx2-encoder',
  'meshoptimizer',
  'three',
  'three-mesh-bvh',
]

/** Returns the names that a file imports, except types. */
function importsOf(path: string): string[] {
  const text = readFileSync(path, 'utf8').replace(/^(import|export) type [^']* from '[^']+'$/gm, '')
  return [...text.matchAll(/(?:from|import|new URL)\s*\(?\s*'([^']+)'/g)].map(([, name]) => name)
}

/** Returns our files that the studio's export loads, and the packages, each with a file that imports it. */
function loaded() {
  const files = new Set<string>()
  const packages = new Map<string, string>()
  const visit = (path: string) => {
    if (files.has(path)) return
    files.add(path)
    for (const name of importsOf(path)) {
      if (name.startsWith('.')) visit(resolve(dirname(path), name))
      else if (name.startsWith('#')) visit(join(FILES, PLATFORMS[name].default))
      else if (name === 'furrow-files') visit(join(FILES, 'src/index.ts'))
      else packages.set(name.replace(/^((?:@[^/]+\/)?[^/]+).*$/, '$1'), relative(ROOT, path))
    }
  }
  for (const name of readdirSync(EXPORT)) visit(join(EXPORT, name))
  return { files: [...files], packages }
}

it("the studio's export imports nothing that needs Node", () => {
  const { files, packages } = loaded()
  expect(files).toContain(join(FILES, 'src/pack/pack.ts'))
  expect([...packages].filter(([name]) => !PORTABLE.includes(name))).toEqual([])
  for (const path of files) {
    expect(readFileSync(path, 'utf8'), relative(ROOT, path)).not.toMatch(/\bBuffer[.(]|\bprocess\./)
  }
})

it.each(Object.entries(PLATFORMS))('%s exports the same names in Node and in browsers', (_, files) => {
  const exportsOf = (file: string) =>
    [...readFileSync(join(FILES, file), 'utf8').matchAll(/^export (?:\{ |(?:async )?function )(\w+)/gm)]
      .map(([, name]) => name)
      .sort()
  expect(exportsOf(files.default)).toEqual(exportsOf(files.node))
  expect(exportsOf(files.node).length).toBeGreaterThan(0)
})
