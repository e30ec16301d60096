import { execFile } from 'node:child_process'
import { cp, mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { promisify } from 'node:util'

export const ROOT = fileURLToPath(new URL('../../', import.meta.url))

/** Runs a program to its end and returns what it printed; rejects, with that, where it fails. */
export async function run(cwd: string, program: string, ...words: string[]): Promise<string> {
  // On Windows npm and npx are scripts, which only a shell can start.
  const options = { cwd, shell: process.platform === 'win32', maxBuffer: 2 ** 26 }
  return promisify(execFile)(program, words, options).then(
    ({ stdout }) => stdout,
    (error) => {
      throw new Error(`${program} ${words.join(' ')}\n${error.stdout}${error.stderr}`)
    },
  )
}

/** A new folder outside the repository, so that nothing resolves to its node_modules. */
export function temporaryFolder(): Promise<string> {
  return mkdtemp(join(tmpdir(), 'furrow-packages-'))
}

/** Packs a workspace as built; returns the tarball's path. */
export async function pack(workspace: string, folder: string): Promise<string> {
  const options = ['--ignore-scripts', '--json', '--pack-destination', folder]
  const [{ filename }] = JSON.parse(await run(ROOT, 'npm', 'pack', '-w', workspace, ...options))
  return join(folder, filename)
}

/** An empty app in which packages are installed, with one of the sources of `apps` where it is named. */
export async function createApp(folder: string, packages: string[], source?: string): Promise<string> {
  await mkdir(folder)
  await writeFile(join(folder, 'package.json'), '{ "private": true, "type": "module" }')
  if (source) await cp(join(ROOT, 'test/packages/apps', source), join(folder, source))
  const options = ['--prefer-offline', '--no-audit', '--no-fund']
  await run(folder, 'npm', 'install', '--prefix', folder, ...options, ...packages)
  return folder
}

export function remove(folder: string): Promise<void> {
  return rm(folder, { recursive: true, force: true })
}
