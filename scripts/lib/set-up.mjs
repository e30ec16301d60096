import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs'
import { join } from 'node:path'
import { Failure, must, ROOT, say } from './run.mjs'

/** The oldest Node that runs everything here, as `engines` in package.json has it. */
const NODE = [20, 19]

/**
 * Packages are built in this order. `result` is what a build writes last, so that a build which was cut off is
 * not taken for whole.
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
const EVERYONES_SOURCES = ['package-lock.json', 'tsconfig.base.json']

/** Makes a clone ready to run: packages installed, library and command built. Does only what is missing. */
export async function setUp() {
  checkNode()
  if (!isInstalled()) {
    say('installing packages (npm ci)')
    await must(['npm', 'ci', '--no-audit', '--no-fund'], { quiet: true })
  }
  let stale = false
  for (const build of BUILDS) {
    // Each builds upon the ones before it.
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

/** Whether what npm last installed is what the lock file asks for. */
function isInstalled() {
  const installed = readLock('node_modules/.package-lock.json')
  if (!installed) return false
  return Object.entries(readLock('package-lock.json').packages).every(([path, wanted]) => {
    if (!path.startsWith('node_modules/') && !path.includes('/node_modules/')) return true
    // Packages for other platforms are not installed.
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
  return [...sources, ...EVERYONES_SOURCES].some((source) => newest(join(ROOT, source)) > built)
}

/** When a file, or anything in a folder, last changed; a folder itself changes when a file of it goes. */
function newest(path) {
  const status = statSync(path)
  if (!status.isDirectory()) return status.mtimeMs
  return Math.max(status.mtimeMs, ...readdirSync(path).map((name) => newest(join(path, name))))
}
