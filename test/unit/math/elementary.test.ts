import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, expect, it, test } from 'vitest'
import { atan2, cos, exp, log, power, sin } from '../../../packages/furrow/src/math/elementary.ts'
import { readImports } from '../../../scripts/lib/imports.mjs'
import { seeded } from '../../random.ts'

/** Folders that make bytes of files or maps. */
const FOLDERS = [
  'packages/furrow/src/author',
  'packages/furrow/src/math',
  'packages/furrow/src/core/normals',
  'packages/files/src',
]

const WORKER = 'packages/furrow/src/auto/worker.ts'
/** Modules of which automatic wrinkles import only types. */
const TYPES_ONLY = ['packages/furrow/src/drivers/fields.ts', 'packages/furrow/src/drivers/time/definition.ts']
const BUCKLING = 'packages/furrow/src/author/auto/buckling'

/**
 * Matches functions of `Math` whose rounding differs between engines, and powers other than squares and constant powers of 2. Squares are
 * exact in all engines, but not by the standard.
 */
const ENGINE_ROUNDS =
  /Math\.(a?(sin|cos|tan)h?|atan2|exp|expm1|log|log2|log10|log1p|pow|cbrt|hypot|random)\b|(?<!\b2 )\*\*(?! 2(?![.\d]))|\b2 \*\* (?!-?\d+(?![.\d]))/

/** Returns the difference of two numbers in units in the last place of the second. */
function unitsApart(a: number, b: number): number {
  return a === b ? 0 : Math.abs(a - b) / 2 ** (Math.floor(Math.log2(Math.abs(b))) - 52)
}

describe('elementary functions', () => {
  const random = seeded(1993)
  const between = (low: number, high: number) => low + random() * (high - low)

  it.each([
    { name: 'exp', own: exp, engine: Math.exp, arguments: () => [between(-700, 700)] as const, most: 2 },
    {
      name: 'log',
      own: log,
      engine: Math.log,
      arguments: () => [Math.exp(between(-700, 700))] as const,
      most: 2,
    },
    {
      name: 'log near 1',
      own: log,
      engine: Math.log,
      arguments: () => [between(0.8, 1.3)] as const,
      most: 2,
    },
    { name: 'sin', own: sin, engine: Math.sin, arguments: () => [between(-1e4, 1e4)] as const, most: 2 },
    { name: 'cos', own: cos, engine: Math.cos, arguments: () => [between(-1e4, 1e4)] as const, most: 2 },
    {
      name: 'atan2',
      own: atan2,
      engine: Math.atan2,
      arguments: () => [between(-9, 9), between(-9, 9)] as const,
      most: 2,
    },
    {
      name: 'power',
      own: power,
      engine: Math.pow,
      arguments: () => [between(1e-9, 9), between(0, 3)] as const,
      most: 100,
    },
  ])("$name equals the engine's, to the last bits", ({ own, engine, arguments: make, most }) => {
    for (let i = 0; i < 20_000; i++) {
      const given = make() as [number, number]
      expect(unitsApart(own(...given), engine(...given)), String(given)).toBeLessThanOrEqual(most)
    }
  })

  it('are exact at the ends of their range and at special values', () => {
    const infinity = Number.POSITIVE_INFINITY
    expect([exp(0), exp(-800), exp(800), exp(Number.NaN)]).toEqual([1, 0, infinity, Number.NaN])
    expect([exp(-740), log(5e-324)]).toEqual([Math.exp(-740), Math.log(5e-324)])
    expect([log(1), log(0), log(infinity), log(-1)]).toEqual([0, -infinity, infinity, Number.NaN])
    expect([power(0, 2.2), power(1, 2.2), sin(0), cos(0)]).toEqual([0, 1, 0, 1])
    expect([atan2(0, 1), atan2(0, -1), atan2(1, 0), atan2(-1, 0), atan2(0, 0)]).toEqual([
      0,
      Math.PI,
      Math.PI / 2,
      -Math.PI / 2,
      0,
    ])
  })
})

const importsOf = new Map(readImports(['packages/furrow/src']).map(({ path, imports }) => [path, imports]))

/** Returns a module and all modules that it imports, also indirectly. Later calls skip the modules in `seen`. */
function withImports(path: string, seen = new Set<string>()): string[] {
  if (seen.has(path)) return []
  seen.add(path)
  return [path, ...(importsOf.get(path) ?? []).flatMap((name) => withImports(name, seen))]
}

const filesIn = (folder: string) =>
  readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((file) => file.endsWith('.ts'))
    .map((file) => join(folder, file))

const searched: [name: string, files: string[]][] = [
  ['the worker of automatic wrinkles, with its imports,', withImports(WORKER, new Set(TYPES_ONLY))],
  ...FOLDERS.map((folder): [string, string[]] => [folder, filesIn(folder)]),
]

test.each(searched)('%s uses no arithmetic whose rounding depends on the engine', (_, files) => {
  const uses = files.flatMap((file) =>
    readFileSync(file, 'utf8')
      .split('\n')
      .filter((line) => !/^\s*(\/?\*|\/\/)/.test(line) && ENGINE_ROUNDS.test(line.replace(/\/\/.*/, '')))
      .map((line) => `${file}: ${line.trim()}`),
  )
  expect(files.length).toBeGreaterThan(0)
  expect(uses).toEqual([])
})

test('the buckling solver uses only + - * / and square roots', () => {
  const others = filesIn(BUCKLING).flatMap((file) =>
    [
      ...readFileSync(file, 'utf8').matchAll(
        /[\w)] \*\* \w|Math\.(?!PI|sqrt|abs|min|max|floor|round|imul)\w+/g,
      ),
    ].map(([use]) => `${file}: ${use}`),
  )
  expect(others).toEqual([])
})
