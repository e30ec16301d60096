import { execFile } from 'node:child_process'
import { createHash } from 'node:crypto'
import { existsSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { promisify } from 'node:util'
import { ROOT, run, say } from './run.mjs'

/** Oldest supported version of Python. Equal to `requires-python` in faces/pyproject.toml. */
const OLDEST = [3, 11]
const isAllowed = ([major, minor]) => major > OLDEST[0] || (major === OLDEST[0] && minor >= OLDEST[1])
const NAMES = ['python3', 'python', 'python3.14', 'python3.13', 'python3.12', 'python3.11']
const FOLDER = join(ROOT, 'faces/.venv')
/**
 * File with the hash of the pyproject.toml that was installed. It is written last, so that an interrupted installation
 * starts again.
 */
const INSTALLED = join(FOLDER, 'installed')

/**
 * Creates or updates the virtual environment faces/.venv with the dependencies of faces/pyproject.toml.
 *
 * @returns {Promise<string | undefined>} path of its Python. If the installation fails, prints a message and returns
 *   undefined.
 */
export async function setUpPython() {
  const wanted = createHash('sha256')
    .update(readFileSync(join(ROOT, 'faces/pyproject.toml')))
    .digest('hex')
  const python = join(FOLDER, process.platform === 'win32' ? 'Scripts/python.exe' : 'bin/python')
  if (existsSync(INSTALLED) && readFileSync(INSTALLED, 'utf8') === wanted && (await versionOf(python)))
    return python
  const found = await findPython(NAMES, isAllowed)
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
    say('python   faces/.venv cannot be created, see above; Debian needs the package python3-venv')
    return undefined
  }
  writeFileSync(INSTALLED, wanted)
  return python
}

/**
 * Finds the first Python with an allowed version. Returns undefined if there is none.
 *
 * @param {string[]} names programs to try.
 * @param {(version: [number, number]) => boolean} isAllowed receives the major and the minor version.
 */
export async function findPython(names, isAllowed) {
  for (const name of names) if (isAllowed((await versionOf(name)) ?? [0, 0])) return name
  return undefined
}

/** Returns the major and the minor version, or undefined if the program is missing. */
async function versionOf(python) {
  try {
    const { stdout } = await promisify(execFile)(python, ['-c', 'import sys; print(*sys.version_info[:2])'])
    return stdout.split(' ').map(Number)
  } catch {
    return undefined
  }
}
