import { readFileSync } from 'node:fs'
import { readFile, writeFile } from 'node:fs/promises'
import { join } from 'node:path'
import { afterAll, beforeAll, describe, expect, inject, it } from 'vitest'
import { createApp, DEPENDENCIES, ROOT, remove, run, temporaryFolder } from './npm.ts'

const TSC = join(ROOT, 'node_modules/typescript/bin/tsc')
const { dependencies } = JSON.parse(readFileSync(join(ROOT, 'packages/cli/package.json'), 'utf8'))
const THREE = [DEPENDENCIES.three, DEPENDENCIES.types]
const GLTF_TRANSFORM = [`@gltf-transform/core@${dependencies['@gltf-transform/core']}`]

let folder: string
const { furrow, 'furrow-cli': cli } = inject('tarballs')

beforeAll(async () => {
  folder = await temporaryFolder()
})
afterAll(() => remove(folder))

/** Installs only those peer dependencies that the app's entry points need. */
describe.each([
  {
    source: 'data.ts',
    peers: [],
    prints: {
      areas: ['nose'],
      surprised: true,
      message: expect.stringContaining('unknown version, got 2'),
      inNode: 'web workers are not supported here',
      normal: [128, 128, 255, 128, 128, 255],
    },
  },
  { source: 'gltf.ts', peers: GLTF_TRANSFORM, prints: { areas: ['nose'] } },
  { source: 'scene.ts', peers: THREE, prints: { classes: ['Wrinkles', 'Wrinkles'] } },
  { source: 'webgl.ts', peers: DEPENDENCIES.oldestThree, prints: { classes: ['Wrinkles'] } },
])('apps/$source', ({ source, peers, prints }) => {
  let app: string
  beforeAll(async () => {
    app = await createApp(join(folder, source.replace('.ts', '')), [furrow, ...peers], { source })
  })

  it('compiles for a bundler', () => compile(app, source, 'esnext', 'bundler'))

  it('compiles for Node, and runs', async () => {
    await compile(app, source, 'nodenext', 'nodenext')
    const printed = await run(app, process.execPath, source.replace('.ts', '.js'))
    expect(JSON.parse(printed)).toEqual(prints)
  })
})

/** Type-checks an app with the strictest settings, including declarations of packages. */
async function compile(app: string, source: string, module: string, moduleResolution: string): Promise<void> {
  const compilerOptions = {
    module,
    moduleResolution,
    target: 'es2022',
    // `esnext` has Float16Array, which the declarations of glTF-Transform use.
    lib: ['esnext', 'dom'],
    types: [],
    strict: true,
    exactOptionalPropertyTypes: true,
    noUncheckedIndexedAccess: true,
    skipLibCheck: false,
  }
  await writeFile(join(app, 'tsconfig.json'), JSON.stringify({ compilerOptions, files: [source] }))
  await run(app, process.execPath, TSC)
}

describe('furrow-cli', () => {
  let app: string
  beforeAll(async () => {
    app = await createApp(join(folder, 'cli'), [cli])
  })
  // Offline, so that npx fails for packages that are not installed.
  const npx = (...words: string[]) => run(app, 'npx', '--offline', ...words)

  it('needs no separate furrow package', async () => {
    const { dependencies } = JSON.parse(await run(app, 'npm', 'ls', '--all', '--json'))
    expect(Object.keys(dependencies)).toEqual(['furrow-cli'])
    expect(Object.keys(dependencies['furrow-cli'].dependencies)).not.toContain('furrow')
  })

  it('prints its version', async () => {
    const { version } = JSON.parse(await readFile(join(ROOT, 'packages/cli/package.json'), 'utf8'))
    expect(await npx('furrow-cli', '--version')).toBe(`${version}\n`)
  })

  it('lists its commands', async () => {
    expect(await npx('furrow-cli', '--help')).toMatch(/^Usage: furrow .*\n {2}inspect /s)
  })

  it('runs a batch with its processes', async () => {
    const words = [join(ROOT, 'faces/human.glb'), '--command', 'validate', '--results', 'checked']
    expect(await npx('furrow', 'batch', ...words)).toMatch(/^1 of 1 done\n/)
  })

  it('names the packages that a batch with Redis or S3 needs', async () => {
    const failure = (...words: string[]) => npx('furrow', ...words).then(() => 'nothing', String)
    expect(await failure('worker', '--redis', 'redis://127.0.0.1')).toContain(
      'furrow: --redis needs bullmq ioredis, which is not installed; run npm install bullmq ioredis beside',
    )
    expect(await failure('batch', 's3://faces/in/', '-o', 'out')).toContain(
      'furrow: an s3:// URL needs @aws-sdk/client-s3, which is not installed',
    )
  })

  it('inspects a face under the name `furrow`', async () => {
    expect(await npx('furrow', 'inspect', join(ROOT, 'faces/human.glb'))).toContain('foreheadLeft')
  })
})
