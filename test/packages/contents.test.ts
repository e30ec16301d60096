import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { mkdir, readFile } from 'node:fs/promises'
import { dirname, join, resolve } from 'node:path'
import { checkPackage, createPackageFromTarballData } from '@arethetypeswrong/core'
import { publint } from 'publint'
import { formatMessage } from 'publint/utils'
import { afterAll, beforeAll, describe, expect, inject, it } from 'vitest'
import { importsIn } from '../../scripts/lib/imports.mjs'
import { ROOT, remove, run, temporaryFolder } from './npm.ts'

/** Resolution modes of TypeScript that find only CommonJS. Both packages are ES modules, so problems in these modes do not count. */
const COMMONJS = ['node10', 'node16-cjs']

let folder: string
beforeAll(async () => {
  folder = await temporaryFolder()
})
afterAll(() => remove(folder))

describe.each([
  { name: 'furrow', top: ['LICENSE', 'README.md', 'dist', 'package.json', 'src'] },
  {
    name: 'furrow-cli',
    top: ['LICENSE', 'README.md', 'THIRD_PARTY_NOTICES.md', 'bin', 'dist', 'package.json'],
  },
] as const)('the tarball of $name', ({ name, top }) => {
  let tarball: Buffer<ArrayBuffer>
  let content: string
  let files: string[]

  beforeAll(async () => {
    const path = inject('tarballs')[name]
    const target = join(folder, name)
    await mkdir(target)
    await run(target, 'tar', '-xzf', path)
    tarball = await readFile(path)
    content = join(target, 'package')
    files = readdirSync(content, { recursive: true, encoding: 'utf8' }).map((file) => join(content, file))
  })
  const read = (file: string) => readFileSync(file, 'utf8')

  it('holds the files that users need', () => {
    expect(readdirSync(content).sort()).toEqual(top)
    expect(read(join(content, 'LICENSE'))).toBe(read(join(ROOT, 'LICENSE')))
  })

  it('holds no tests, caches or hidden files', () => {
    const paths = files.map((file) => file.slice(content.length + 1))
    expect(paths.filter((path) => /(^|\/)(\.|node_modules\b)|\.test\.|\.tsbuildinfo$/.test(path))).toEqual([])
  })

  it('passes publint', async () => {
    const { buffer, byteOffset, length } = tarball
    const { messages, pkg } = await publint({
      pack: { tarball: buffer.slice(byteOffset, byteOffset + length) },
      strict: true,
    })
    expect(messages.map((message) => formatMessage(message, pkg))).toEqual([])
  })

  it('has source maps whose sources exist', () => {
    const maps = files.filter((file) => file.endsWith('.map'))
    expect(maps.length).toBeGreaterThan(10)
    for (const map of maps) {
      const { sources, sourcesContent } = JSON.parse(read(map))
      const missing = (source: string, i: number) =>
        !sourcesContent?.[i] && !existsSync(resolve(dirname(map), source))
      expect(sources.filter(missing), map).toEqual([])
    }
  })

  it('imports only its own files, Node modules and its dependencies', () => {
    const { dependencies, peerDependencies } = JSON.parse(read(join(content, 'package.json')))
    const allowed = Object.keys({ ...dependencies, ...peerDependencies })
    const imported = files
      .filter((file) => file.endsWith('.js') && !file.startsWith(join(content, 'dist/page/')))
      .flatMap((file) => importsIn(file, read(file)))
      .map(({ specifier }) => specifier)
      .filter((specifier) => !/^(\.|node:)/.test(specifier))
    expect(imported.length).toBeGreaterThan(5)
    const installed = (specifier: string) =>
      allowed.some((one) => specifier === one || specifier.startsWith(`${one}/`))
    expect(imported.filter((specifier) => !installed(specifier))).toEqual([])
  })

  it('exports and imports no internal entry point', () => {
    const { exports, imports } = JSON.parse(read(join(content, 'package.json')))
    expect(Object.keys(exports).filter((entry) => entry.includes('internal'))).toEqual([])
    expect(imports).toBeUndefined()
    expect(files.filter((file) => /\binternal\b/.test(file.slice(content.length)))).toEqual([])
    const imported = files
      .filter((file) => /\.([cm]?js|ts)$/.test(file))
      .filter((file) => {
        return /from ?['"](furrow\/internal|furrow-files)/.test(read(file))
      })
    expect(imported).toEqual([])
  })

  if (name !== 'furrow') return

  it('has types that resolve at every entry point', async () => {
    const analysis = await checkPackage(createPackageFromTarballData(tarball))
    if (!analysis.types) throw new Error('there are no types')
    const problems = analysis.problems.filter(
      (problem) => !('resolutionKind' in problem && COMMONJS.includes(problem.resolutionKind)),
    )
    expect(problems).toEqual([])
  })

  // Checks only relative imports: other packages state their own side effects.
  it('imports no module of its own for side effects, as "sideEffects": false promises', () => {
    const modules = files.filter((file) => file.endsWith('.js'))
    expect(modules.length).toBeGreaterThan(10)
    expect(modules.filter((file) => /^import ['"]\./m.test(read(file)))).toEqual([])
  })
})
