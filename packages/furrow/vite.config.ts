import { createHash } from 'node:crypto'
import { fileURLToPath } from 'node:url'
import { build, defineConfig, type Plugin } from 'vite'
import manifest from './package.json' with { type: 'json' }

const src = (path: string) => fileURLToPath(new URL(`src/${path}`, import.meta.url))

/** Sources of the published entries, by their files in dist without the ending. */
const ENTRIES = Object.fromEntries(
  Object.values(manifest.exports)
    .filter((entry) => typeof entry === 'object')
    .map((entry) => [
      entry.default.replace(/^\.\/dist\/|\.js$/g, ''),
      src(entry['furrow-source'].replace('./src/', '')),
    ]),
)

const PEERS = Object.keys(manifest.peerDependencies)

/**
 * Builds each published entry as one file, with chunks for what several entries share and for what is imported dynamically. No
 * module is in two files, so all entries have the same classes and registries.
 */
export default defineConfig({
  logLevel: 'warn',
  resolve: { conditions: ['furrow-source', 'module', 'browser', 'development|production'] },
  plugins: [workerAsText()],
  build: {
    // `tsc` has written the types there.
    emptyOutDir: false,
    sourcemap: true,
    minify: false,
    target: 'es2022',
    lib: { entry: ENTRIES, formats: ['es'] },
    rolldownOptions: {
      // Needed by the chunks below. No module of an entry is imported by another chunk, so none gets further exports.
      preserveEntrySignatures: 'allow-extension',
      external: (id) => PEERS.some((peer) => id === peer || id.startsWith(`${peer}/`)),
      output: {
        entryFileNames: '[name].js',
        chunkFileNames: 'chunks/[name].js',
        codeSplitting: {
          includeDependenciesRecursively: false,
          groups: [{ name: chunkOf, debugName: 'rooms' }],
        },
        // Readable, and the same in every build.
        minifyInternalExports: false,
        // The package has the sources.
        sourcemapExcludeSources: true,
      },
    },
  },
})

/** Rooms that are chunks: the first one that has a module. Engines and frameworks, whose rooms are not listed, have a chunk each. */
const CHUNKS: [chunk: string, room: RegExp][] = [
  ['webgl', /^three\/webgl\//],
  ['webgpu', /^three\/webgpu\//],
  [
    'core',
    /^(core|math|drivers|runtime|relief)\/|^auto\/run-options|^author\/auto\/(options|anatomy\/region-names)/,
  ],
]

/** Rooms of one entry each, which has them in its own file. */
const SINGLE_ENTRY = /^(author|gltf|inspector)\//

/** The same of modules that are imported dynamically, and of what only these import. */
const LAZY_CHUNKS: typeof CHUNKS = [
  ['relief-webgl', /^three\/webgl\/relief\//],
  ['relief-webgpu', /^three\/webgpu\/relief\//],
  ['relief', /(^|\/)relief\//],
  ['auto-worker', /^auto\//],
]

interface Graph {
  getModuleInfo(id: string): { isEntry: boolean; importers: string[] } | null
}

/** Few chunks, by rooms: a page without a bundler requests each. Bundlers leave out what a page does not use of them. */
function chunkOf(id: string, graph: Graph): string | null {
  if (!id.startsWith(src('')) || graph.getModuleInfo(id)?.isEntry) return null
  const path = id.slice(src('').length)
  if (!isEager(id, graph)) return nameIn(LAZY_CHUNKS, path)
  return nameIn(CHUNKS, path) ?? (SINGLE_ENTRY.test(path) ? null : path.split('/')[0]!)
}

function nameIn(chunks: typeof CHUNKS, path: string): string | null {
  return chunks.find(([, room]) => room.test(path))?.[0] ?? null
}

const eager = new Map<string, boolean>()

/** Whether an entry imports a module, not dynamically. The library has no circular imports. */
function isEager(id: string, graph: Graph): boolean {
  const known = eager.get(id)
  if (known !== undefined) return known
  const { isEntry, importers } = graph.getModuleInfo(id)!
  const found = isEntry || importers.some((importer) => isEager(importer, graph))
  eager.set(id, found)
  return found
}

/** Puts the worker of `furrow/auto` into the package as one string, see src/auto/start-worker.ts. */
function workerAsText(): Plugin {
  return {
    name: 'worker-as-text',
    async load(id) {
      if (id !== src('auto/start-worker.ts')) return null
      const [{ output }] = (await build({
        configFile: false,
        logLevel: 'warn',
        build: {
          write: false,
          target: 'es2022',
          lib: { entry: src('auto/worker.ts'), formats: ['iife'], name: 'worker' },
        },
      })) as { output: { code: string }[] }[]
      const [{ code }] = output
      return `const SOURCE = ${JSON.stringify(code)}

/** A hash of the code in the worker. */
export const version = '${createHash('sha256').update(code).digest('hex').slice(0, 16)}'

let address

/** Starts the worker. The address is kept for the next one. */
export function startWorker() {
  address ??= URL.createObjectURL(new Blob([SOURCE], { type: 'text/javascript' }))
  return new Worker(address)
}
`
    },
  }
}
