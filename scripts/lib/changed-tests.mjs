import { spawnSync } from 'node:child_process'
import { existsSync, readFileSync, statSync } from 'node:fs'
import { dirname, join, relative, resolve } from 'node:path'
import { ROOT } from './run.mjs'
import { SOURCES } from './sources.mjs'

/** Number of recent commits to compare with on the main branch. */
const COMMITS = 20

/** Folders of tests that run builds or served pages, so their imports do not show their dependencies. */
const RUN_BUILDS = ['pages', 'packages', 'batch', 'site']

/** Files that are not part of builds. */
const NOT_BUILT = /^(test|docs|bench|blender|conformance|\.github|\.ci)\/|\.md$/

/**
 * Sorts tests that import recently changed files before all others. Each commit starts both groups elsewhere, so that every test
 * runs now and then even if time is limited.
 *
 * @template {{ file: string }} T
 * @param {T[]} tests
 * @returns {T[]}
 */
export function changedFirst(tests) {
  const changed = changedFiles()
  const rotated = rotate(tests, commitNumber())
  const isChanged = testsImporting(changed)
  return [...rotated.filter(isChanged), ...rotated.filter((test) => !isChanged(test))]
}

/** Visits the list in strides, which separates neighbours. The number selects the first element. */
function rotate(list, number) {
  // A prime stride visits every element unless it divides the length.
  const stride = list.length % 61 === 0 ? 59 : 61
  return list.map((_, i) => list[((number + i) * stride) % list.length])
}

/** Returns a predicate for tests that import a changed file, directly or indirectly. */
function testsImporting(changed) {
  const importsOfTest = importCollector()
  const isBuildChanged = changed.some((file) => !NOT_BUILT.test(file))
  const paths = new Set(changed)
  return ({ file }) => {
    if (isBuildChanged && RUN_BUILDS.includes(file.split('/')[1])) return true
    return [...importsOfTest(file)].some((path) => paths.has(path))
  }
}

/** Returns a function that collects a file and its direct and indirect imports. */
function importCollector() {
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

/** Lists a package's entry points, such as `furrow/three`, with their sources. */
function exportsOf(folder) {
  const { name, exports = {} } = JSON.parse(
    readFileSync(join(ROOT, 'packages', folder, 'package.json'), 'utf8'),
  )
  return Object.entries(exports).flatMap(([entry, conditions]) => {
    const source = conditions['furrow-source']
    return source ? [[join(name, entry), join('packages', folder, source)]] : []
  })
}

/** Lists the repository's files that a file names in quotes, by specifier or relative path. */
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

/** Lists files changed on this branch, or by the last commits on the main branch. */
function changedFiles() {
  const head = git('rev-parse', 'HEAD')
  const base = git('merge-base', 'HEAD', 'origin/main')
  const start = base && base !== head ? base : git('rev-parse', '--verify', '--quiet', `HEAD~${COMMITS}`)
  // In a shallow clone every file counts as changed.
  return start ? git('diff', '--name-only', start).split('\n') : git('ls-files').split('\n')
}

/** Returns the number of commits, or a number derived from the hash in a shallow clone. */
function commitNumber() {
  const isShallow = git('rev-parse', '--is-shallow-repository') === 'true'
  return isShallow
    ? Number.parseInt(git('rev-parse', 'HEAD').slice(0, 8), 16)
    : Number(git('rev-list', '--count', 'HEAD'))
}

/** Returns git's output, empty if git fails. */
function git(...words) {
  return spawnSync('git', words, { cwd: ROOT, encoding: 'utf8' }).stdout.trim()
}
