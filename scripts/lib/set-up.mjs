import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs'
import { join } from 'node:path'
import { Failure, must, ROOT, say } from './run.mjs'

/** Oldest supported version of Node. Equal to `engines` in package.json. */
const NODE = [20, 19]

/**
 * Packages in build order. The build writes `result` last, so that a package with an interrupted build is built again.
 */
const BUILDS = [
  {
    name: 'furrow',
    result: 'packages/furrow/dist/index.js',
    sources: ['packages/furrow/src', 'packages/furrow/package.json', 'packages/furrow/tsconfig.json'],
  },
  {
    name: 'furrow-cli',
    result: 'packages/cli/dist/page/index.html',
    sources: [
      'packages/cli/src',
      'packages/cli/package.json',
      'packages/cli/vite.config.ts',
      'packages/files',
      'stage',
    ],
  },
]
const SHARED_SOURCES = ['package-lock.json', 'tsconfig.base.json']

/** Installs packages and builds the library and the CLI. Skips steps that are up to date. */
export async function setUp() {
  checkNode()
  if (!isInstalled()) {
    say('installing packages (npm ci)')
    await must(['npm', 'ci', '--no-audit', '--no-fund'], { quiet: true })
  }
  let stale = false
  for (const build of BUILDS) {
    // A package depends on the packages before it, so it is stale if one of them is.
    stale ||= isStale(build)
    if (!stale) continue
    say(`building ${build.name}`)
    await must(['npm', 'run', 'build', '-w', build.name], { quiet: true })
  }
}

function checkNode() {
  const [major, minor] = process.versions.node.split('.').map(Number)
  if (major > NODE[0] || (major === NODE[0] && minor >= NODE[1])) return
  throw new Failure(
    `Node ${process.versions.node} is too old, allowed: ${NODE.join('.')} or later; install a newer one`,
  )
}

/** Returns whether the installed packages match the lock file. */
function isInstalled() {
  const installed = readLock('node_modules/.package-lock.json')
  if (!installed) return false
  return Object.entries(readLock('package-lock.json').packages).every(([path, wanted]) => {
    if (!path.startsWith('node_modules/') && !path.includes('/node_modules/')) return true
    // Optional packages for other platforms are not installed.
    const found = installed.packages[path]
    return found ? found.version === wanted.version && existsSync(join(ROOT, path)) : wanted.optional
  })
}

function readLock(path) {
  const file = join(ROOT, path)
  return existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : undefined
}

function isStale({ result, sources }) {
  const file = join(ROOT, result)
  if (!existsSync(file)) return true
  const built = statSync(file).mtimeMs
  return [...sources, ...SHARED_SOURCES].some((source) => newest(join(ROOT, source)) > built)
}

/**
 * Returns the modification time of a file, or the latest modification time in a folder. The time of the folder itself
 * counts too, because it changes when a file is removed.
 */
function newest(path) {
  const status = statSync(path)
  if (!status.isDirectory()) return status.mtimeMs
  return Math.max(status.mtimeMs, ...readdirSync(path).map((name) => newest(join(path, name))))
}
