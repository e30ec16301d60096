import { spawnSync } from 'node:child_process'
import { existsSync, readFileSync, statSync } from 'node:fs'
import { dirname, join, relative, resolve } from 'node:path'
import { ROOT } from './run.mjs'
import { SOURCES } from './sources.mjs'

/** On the main branch itself what its last commits changed counts as changed. */
const COMMITS = 20

/** Tests in these folders run what was built or is served, which their imports do not tell. */
const RUN_EVERYTHING = ['pages', 'packages', 'batch', 'site']

/** Files that those do not run. */
const NOT_RUN = /^(test|docs|bench|blender|conformance|\.github|\.ci)\/|\.md$/

/**
 * Tests whose files import what changed lately, then all others. Both begin elsewhere with each commit, so that all of them
 * run once in a while where there is no time for all.
 *
 * @template {{ file: string }} T
 * @param {T[]} tests
 * @returns {T[]}
 */
export function changedFirst(tests) {
  const changed = changedFiles()
  const turned = turn(tests, commitNumber())
  const isChanged = changedTests(changed)
  return [...turned.filter(isChanged), ...turned.filter((test) => !isChanged(test))]
}

/** All elements in strides, which mix what stands together, and with another one first for each number. */
function turn(list, number) {
  // Strides of a prime visit all of a list that is no multiple of it.
  const stride = list.length % 61 === 0 ? 59 : 61
  return list.map((_, i) => list[((number + i) * stride) % list.length])
}

/** Whether a test imports a changed file, by other files or not. */
function changedTests(changed) {
  const reach = reader()
  const runsChanged = changed.some((file) => !NOT_RUN.test(file))
  const paths = new Set(changed)
  return ({ file }) => {
    if (runsChanged && RUN_EVERYTHING.includes(file.split('/')[1])) return true
    return [...reach(file)].some((path) => paths.has(path))
  }
}

/** A function from a file to all that it imports, itself included. */
function reader() {
  const imports = new Map()
  return (start) => {
    const found = new Set([start])
    for (const file of found) {
      if (!imports.has(file)) imports.set(file, importsOf(file))
      for (const next of imports.get(file)) found.add(next)
    }
    return found
  }
}

const PACKAGES = ['furrow', 'cli', 'files'].filter((name) => existsSync(join(ROOT, 'packages', name)))
const EXPORTS = new Map([
  ...PACKAGES.flatMap(exportsOf),
  ...Object.entries(SOURCES.resolve.alias).map(([name, path]) => [name, relative(ROOT, path)]),
])

/** Sources of a package, by what others import: `furrow/three`. */
function exportsOf(folder) {
  const { name, exports = {} } = JSON.parse(
    readFileSync(join(ROOT, 'packages', folder, 'package.json'), 'utf8'),
  )
  return Object.entries(exports).flatMap(([entry, conditions]) => {
    const source = conditions['furrow-source']
    return source ? [[join(name, entry), join('packages', folder, source)]] : []
  })
}

/** Files of the repository that a file names: modules, and others by their relative paths. */
function importsOf(file) {
  if (!/\.(ts|tsx|mjs|mts|js|html)$/.test(file)) return []
  const text = readFileSync(join(ROOT, file), 'utf8')
  const names = [...text.matchAll(/['"]([^'"\n]+)['"]/g)].map(([, name]) => name)
  return names.flatMap((name) => {
    if (EXPORTS.has(name)) return [EXPORTS.get(name)]
    if (!name.startsWith('.')) return []
    const path = resolve(ROOT, dirname(file), name)
    return existsSync(path) && statSync(path).isFile() ? [relative(ROOT, path)] : []
  })
}

/** Files that changed since this branch left the main one, or, on that, in its last commits. */
function changedFiles() {
  const head = git('rev-parse', 'HEAD')
  const base = git('merge-base', 'HEAD', 'origin/main')
  const start = base && base !== head ? base : git('rev-parse', '--verify', '--quiet', `HEAD~${COMMITS}`)
  // In a clone without so many commits everything counts as changed.
  return start ? git('diff', '--name-only', start).split('\n') : git('ls-files').split('\n')
}

/** Grows by one with each commit; in a shallow clone, which cannot count, it is any number. */
function commitNumber() {
  const isShallow = git('rev-parse', '--is-shallow-repository') === 'true'
  return isShallow
    ? Number.parseInt(git('rev-parse', 'HEAD').slice(0, 8), 16)
    : Number(git('rev-list', '--count', 'HEAD'))
}

/** Output of git; empty where it fails. */
function git(...words) {
  return spawnSync('git', words, { cwd: ROOT, encoding: 'utf8' }).stdout.trim()
}
