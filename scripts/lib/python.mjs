import { execFile } from 'node:child_process'
import { createHash } from 'node:crypto'
import { existsSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { promisify } from 'node:util'
import { ROOT, run, say } from './run.mjs'

/** As `requires-python` in faces/pyproject.toml has it. */
const OLDEST = [3, 11]
const isAllowed = ([major, minor]) => major > OLDEST[0] || (major === OLDEST[0] && minor >= OLDEST[1])
const NAMES = ['python3', 'python', 'python3.14', 'python3.13', 'python3.12', 'python3.11']
const FOLDER = join(ROOT, 'faces/.venv')
/** Where the hash of what was installed is kept; written last. */
const INSTALLED = join(FOLDER, 'installed')

/**
 * Makes a virtual environment in faces/.venv with what faces/pyproject.toml asks for, unless it is there.
 *
 * @returns {Promise<string | undefined>} path of its Python; undefined, and it is said why, where it cannot be made.
 */
export async function setUpPython() {
  const wanted = createHash('sha256')
    .update(readFileSync(join(ROOT, 'faces/pyproject.toml')))
    .digest('hex')
  const python = join(FOLDER, process.platform === 'win32' ? 'Scripts/python.exe' : 'bin/python')
  if (existsSync(INSTALLED) && readFileSync(INSTALLED, 'utf8') === wanted && (await versionOf(python)))
    return python
  const found = await pythonNamed(NAMES, isAllowed)
  if (!found) {
    say(`python   missing, allowed: ${OLDEST.join('.')} or later; install it to check faces/`)
    return undefined
  }
  say('installing Python packages (faces/.venv)')
  const pip = [
    python,
    '-m',
    'pip',
    'install',
    '--quiet',
    '--disable-pip-version-check',
    '--editable',
    'faces[dev]',
  ]
  for (const words of [[found, '-m', 'venv', '--clear', FOLDER], pip]) {
    if ((await run(words, { quiet: true })) === 0) continue
    say('python   faces/.venv cannot be made; see above, Debian has venv in the package python3-venv')
    return undefined
  }
  writeFileSync(INSTALLED, wanted)
  return python
}

/**
 * The first Python of these names whose version is allowed; undefined if there is none.
 *
 * @param {string[]} names
 * @param {(version: [number, number]) => boolean} allows major and minor number.
 */
export async function pythonNamed(names, allows) {
  for (const name of names) if (allows((await versionOf(name)) ?? [0, 0])) return name
  return undefined
}

/** Major and minor number; undefined where there is no such program. */
async function versionOf(python) {
  try {
    const { stdout } = await promisify(execFile)(python, ['-c', 'import sys; print(*sys.version_info[:2])'])
    return stdout.split(' ').map(Number)
  } catch {
    return undefined
  }
}
