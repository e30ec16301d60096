import { execFile } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { cp, mkdir, mkdtemp, rm, symlink, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath, pathToFileURL } from 'node:url'
import { promisify } from 'node:util'

export const ROOT = fileURLToPath(new URL('../../', import.meta.url))

const { devDependencies } = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8'))
const at = (name: string) => `${name}@${devDependencies[name]}`

/** Packages that the test applications install in addition to Furrow, with the tested versions. */
export const DEPENDENCIES = {
  three: at('three'),
  types: at('@types/three'),
  oldestThree: ['three@0.160', '@types/three@0.160'],
  vite: at('vite'),
  typescript: at('typescript'),
  react: [
    'react',
    'react-dom',
    '@types/react',
    '@types/react-dom',
    '@react-three/fiber',
    '@react-three/drei',
  ].map(at),
  oldestReact: [
    'react@18',
    'react-dom@18',
    '@types/react@18',
    '@types/react-dom@18',
    '@react-three/fiber@8',
    '@react-three/drei@9',
  ],
  babylon: ['@babylonjs/core', '@babylonjs/loaders'].map(at),
  oldestBabylon: ['babylon-oldest', 'babylon-loaders-oldest'].map((name) =>
    devDependencies[name].replace('npm:', ''),
  ),
  // The repository's package.json does not list these packages, because only test applications use them.
  webpack: 'webpack@5.112.2',
  esbuild: 'esbuild@0.28.2',
}

/** Runs a program and returns its output. Rejects with the output if the program fails. */
export async function run(cwd: string, program: string, ...words: string[]): Promise<string> {
  // On Windows npm and npx are scripts, which need a shell.
  const options = { cwd, shell: process.platform === 'win32', maxBuffer: 2 ** 26 }
  return promisify(execFile)(program, words, options).then(
    ({ stdout }) => stdout,
    (error) => {
      throw new Error(`${program} ${words.join(' ')}\n${error.stdout}${error.stderr}`)
    },
  )
}

/** Creates a folder outside the repository, so that no import resolves to the repository's node_modules. */
export function temporaryFolder(): Promise<string> {
  return mkdtemp(join(tmpdir(), 'furrow-packages-'))
}

/** Packs a built workspace. Returns the tarball's path. */
export async function pack(workspace: string, folder: string): Promise<string> {
  const options = ['--ignore-scripts', '--json', '--pack-destination', folder]
  const [{ filename }] = JSON.parse(await run(ROOT, 'npm', 'pack', '-w', workspace, ...options))
  return join(folder, filename)
}

/**
 * Creates an empty app and installs packages in it.
 *
 * @param options `source`: file or folder of `apps` to copy. `overrides`: field of the same name in package.json.
 */
export async function createApp(
  folder: string,
  packages: string[],
  { source, overrides }: { source?: string; overrides?: Record<string, string> } = {},
): Promise<string> {
  await mkdir(folder)
  await writeFile(join(folder, 'package.json'), JSON.stringify({ private: true, type: 'module', overrides }))
  if (source) await cp(join(ROOT, 'test/packages/apps', source), join(folder, source))
  const options = ['--prefer-offline', '--no-audit', '--no-fund']
  await run(folder, 'npm', 'install', '--prefix', folder, ...options, ...packages)
  return folder
}

/**
 * Runs a package with `npx` without installing it. From npm's usual cache, npx could run an older build of a tarball with the same name. So
 * this function uses a temporary cache, which shares only downloads with the usual cache.
 *
 * @param tarball path of the package, relative to the folder.
 */
export async function runUninstalled(folder: string, tarball: string, ...words: string[]): Promise<string> {
  const cache = await temporaryFolder()
  try {
    const used = (await run(folder, 'npm', 'config', 'get', 'cache')).trim()
    await mkdir(join(used, '_cacache'), { recursive: true })
    await symlink(join(used, '_cacache'), join(cache, '_cacache'), 'junction')
    return await run(folder, 'npx', '--yes', '--prefer-offline', '--cache', cache, tarball, ...words)
  } finally {
    await remove(cache)
  }
}

/** Serves the build of an app, with the version of Vite that the app has installed. */
export async function previewServer(app: string): Promise<{ origin: string; close(): Promise<void> }> {
  const { preview }: typeof import('vite') = await import(
    pathToFileURL(join(app, 'node_modules/vite/dist/node/index.js')).href
  )
  const server = await preview({ root: app, logLevel: 'warn', preview: { host: '127.0.0.1', port: 0 } })
  const origin = server.resolvedUrls?.local[0]?.replace(/\/$/, '')
  if (!origin) throw new Error('Vite does not say where it listens')
  return { origin, close: () => server.close() }
}

export function remove(folder: string): Promise<void> {
  return rm(folder, { recursive: true, force: true })
}
