// `npm run test:blender`: tests the Blender extension in Blender. `-- --version 4.5` selects a version of Blender, and
// `-- test_drivers.py` selects test files.

import { existsSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { findPython } from './lib/python.mjs'
import { Failure, main, must, ROOT, run, say } from './lib/run.mjs'

/** The LTS version of Blender, and the newest version on PyPI that needs the same version of Python. */
const VERSIONS = ['4.5', '5.0']

await main(async () => {
  const { values, positionals } = parseArgs({
    options: { version: { type: 'string', multiple: true, default: VERSIONS } },
    allowPositionals: true,
  })
  for (const version of values.version) {
    if (VERSIONS.includes(version)) continue
    throw new Failure(
      `--version is unsupported, got "${version}", allowed: ${VERSIONS.join(' or ')}; write e.g. --version 4.5`,
    )
  }
  if (!existsSync(join(ROOT, 'packages/cli/dist'))) await must(['npm', 'run', '--silent', 'build'])
  const failed = []
  for (const version of values.version) {
    const python = await setUp(version)
    say(`Blender ${version}`)
    if ((await run([python, 'blender/tests/run.py', ...positionals])) !== 0) failed.push(version)
  }
  if (failed.length > 0) throw new Failure(`failed on Blender ${failed.join(', ')}`)
})

/** Installs Blender as a Python module in blender/.venv-VERSION. Returns the path of this Python. */
async function setUp(version) {
  const folder = join(ROOT, `blender/.venv-${version}`)
  const python = join(folder, process.platform === 'win32' ? 'Scripts/python.exe' : 'bin/python')
  // This file is written last, so that an interrupted installation starts again.
  const installed = join(folder, 'installed')
  if (existsSync(installed)) return python
  const found = await findPython(
    ['python3.11', 'python3', 'python'],
    ([major, minor]) => major === 3 && minor === 11,
  )
  if (!found) throw new Failure('Python 3.11 is missing, which bpy requires; install it')
  say(
    `installing Blender ${version} as a Python module: downloads about 350 MB, takes 950 MB (blender/.venv-${version})`,
  )
  await must([found, '-m', 'venv', '--clear', folder])
  await must([python, '-m', 'pip', 'install', '--quiet', '--disable-pip-version-check', `bpy==${version}.*`])
  writeFileSync(installed, '')
  return python
}
