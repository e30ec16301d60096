import { spawnSync } from 'node:child_process'
import { existsSync, readFileSync, statSync } from 'node:fs'
import { dirname, join, relative, resolve } from 'node:path'
import { ROOT } from './run.mjs'
import { SOURCES } from './sources.mjs'

/** Number of last commits whose files count as changed on the main branch. */
const COMMITS = 20

/**
 * Folders of tests that run built packages or pages. The imports of such a test do not include all files on which it depends.
 */
const RUN_BUILDS = ['pages', 'packages', 'batch', 'site']

/** Files that are not part of any build. */
const NOT_BUILT = /^(test|docs|bench|blender|conformance|\.github|\.ci)\/|\.md$/

/**
 * Sorts tests into two groups: first the tests that import recently changed files, then all others. Each commit starts
 * both groups at a different test. Over many commits, every test runs, even if the time for each commit is limited.
 */
export function changedFirst(tests) {
  const changed = changedFiles()
  const rotated = rotate(tests, commitNumber())
  const isChanged = testsImporting(changed)
  return [...rotated.filter(isChanged), ...rotated.filter((test) => !isChanged(test))]
}

/** Moves neighbours in a list far apart. `number` selects the first element. */
function rotate(list, number) {
  // A step of 61 or 59, both primes, visits every element if it does not divide the length of the list.
  const stride = list.length % 61 === 0 ? 59 : 61
  return list.map((_, i) => list[((number + i) * stride) % list.length])
}

/**
 * Returns a function that tells whether a test imports a changed file, directly or indirectly. If a file of a build
 * changed, the function also returns true for tests in `RUN_BUILDS`.
 */
function testsImporting(changed) {
  const importsOfTest = importCollector()
  const isBuildChanged = changed.some((file) => !NOT_BUILT.test(file))
  const paths = new Set(changed)
  return ({ file }) => {
    if (isBuildChanged && RUN_BUILDS.includes(file.split('/')[1])) return true
    return [...importsOfTest(file)].some((path) => paths.has(path))
  }
}

/** Returns a function that finds a file's direct and indirect imports. The result includes the file. */
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

/** Returns the entry points of a package, such as `furrow/three`, with the paths of their sources. */
function exportsOf(folder) {
  const { name, exports = {} } = JSON.parse(
    readFileSync(join(ROOT, 'packages', folder, 'package.json'), 'utf8'),
  )
  return Object.entries(exports).flatMap(([entry, conditions]) => {
    const source = conditions['furrow-source']
    return source ? [[join(name, entry), join('packages', folder, source)]] : []
  })
}

/**
 * Returns the repository's files that one file imports or names in quotes. The names are relative paths or entry points
 * of packages.
 */
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

/**
 * Returns the files that this branch has changed. On the main branch, returns the files that the last `COMMITS` commits
 * have changed.
 */
function changedFiles() {
  const head = git('rev-parse', 'HEAD')
  const base = git('merge-base', 'HEAD', 'origin/main')
  const start = base && base !== head ? base : git('rev-parse', '--verify', '--quiet', `HEAD~${COMMITS}`)
  // In a shallow clone, git may not find the first commit to compare with. Then every file counts as changed.
  return start ? git('diff', '--name-only', start).split('\n') : git('ls-files').split('\n')
}

/**
 * Returns the number of commits. In a shallow clone, git does not know this number. There, the result is derived from
 * the hash.
 */
function commitNumber() {
  const isShallow = git('rev-parse', '--is-shallow-repository') === 'true'
  return isShallow
    ? Number.parseInt(git('rev-parse', 'HEAD').slice(0, 8), 16)
    : Number(git('rev-list', '--count', 'HEAD'))
}

/** Returns the output of git, or an empty text if git fails. */
function git(...words) {
  return spawnSync('git', words, { cwd: ROOT, encoding: 'utf8' }).stdout.trim()
}
