import { createHash } from 'node:crypto'
import { fileURLToPath } from 'node:url'
import { build, defineConfig, type Plugin } from 'vite'
import manifest from './package.json' with { type: 'json' }

const src = (path: string) => fileURLToPath(new URL(`src/${path}`, import.meta.url))

/** Source file of each published entry, by its path in `dist` without `.js`. */
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
 * Builds one file for each published entry. Modules that several entries share, and modules that are imported dynamically, are in chunks. No
 * module is in two files, so all entries share the same classes and registries.
 */
export default defineConfig({
  logLevel: 'warn',
  resolve: { conditions: ['furrow-source', 'module', 'browser', 'development|production'] },
  plugins: [workerAsText()],
  build: {
    // `dist` already contains the type declarations that `tsc` has written.
    emptyOutDir: false,
    sourcemap: true,
    minify: false,
    target: 'es2022',
    lib: { entry: ENTRIES, formats: ['es'] },
    rolldownOptions: {
      // `codeSplitting` requires this value. It lets the bundler add exports to an entry that a chunk imports, but no chunk imports an entry.
      preserveEntrySignatures: 'allow-extension',
      external: (id) => PEERS.some((peer) => id === peer || id.startsWith(`${peer}/`)),
      output: {
        entryFileNames: '[name].js',
        chunkFileNames: 'chunks/[name].js',
        codeSplitting: {
          includeDependenciesRecursively: false,
          groups: [{ name: chunkOf, debugName: 'rooms' }],
        },
        // Chunks export full names, which are readable and do not change between builds.
        minifyInternalExports: false,
        // The published package contains the source files.
        sourcemapExcludeSources: true,
      },
    },
  },
})

/**
 * Chunks of modules that entries import statically. A module is put into the first chunk whose pattern matches its path in `src`. A module
 * without a match is put into a chunk with the name of its folder, unless the folder is in `SINGLE_ENTRY`.
 */
const CHUNKS: [chunk: string, pattern: RegExp][] = [
  ['webgl', /^three\/webgl\//],
  ['webgpu', /^three\/webgpu\//],
  [
    'core',
    /^(core|math|drivers|runtime|relief)\/|^auto\/run-options|^author\/auto\/(options|anatomy\/region-names|character\/surface-kinds|cloth\/cloth-kinds)/,
  ],
]

/** Folders whose modules belong to one entry. They are put into the file of this entry. */
const SINGLE_ENTRY = /^(author|gltf|inspector|live)\//

/** Chunks of modules that are only loaded by a dynamic import. A module is put into the first chunk whose pattern matches its path. */
const LAZY_CHUNKS: typeof CHUNKS = [
  ['relief-webgl', /^three\/webgl\/relief\//],
  ['relief-webgpu', /^three\/webgpu\/relief\//],
  ['relief', /(^|\/)relief\//],
  ['auto-worker', /^auto\/start-worker\./],
]

interface Graph {
  getModuleInfo(id: string): { isEntry: boolean; importers: string[] } | null
}

/**
 * Returns the chunk of a module, or null if the bundler decides. There are only a few chunks, because a page without a bundler sends a request
 * for each. Bundlers remove unused code from chunks.
 */
function chunkOf(id: string, graph: Graph): string | null {
  if (!id.startsWith(src('')) || graph.getModuleInfo(id)?.isEntry) return null
  const path = id.slice(src('').length)
  if (!isEager(id, graph)) return nameIn(LAZY_CHUNKS, path)
  return nameIn(CHUNKS, path) ?? (SINGLE_ENTRY.test(path) ? null : path.split('/')[0]!)
}

function nameIn(chunks: typeof CHUNKS, path: string): string | null {
  return chunks.find(([, pattern]) => pattern.test(path))?.[0] ?? null
}

const eager = new Map<string, boolean>()

/**
 * Whether an entry imports a module statically, directly or through other modules. The recursion ends, because the library has no circular
 * imports.
 */
function isEager(id: string, graph: Graph): boolean {
  const known = eager.get(id)
  if (known !== undefined) return known
  const { isEntry, importers } = graph.getModuleInfo(id)!
  const found = isEntry || importers.some((importer) => isEager(importer, graph))
  eager.set(id, found)
  return found
}

/** Replaces `src/auto/start-worker.ts` by a module that contains the bundled worker of `furrow/auto` as a string. */
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

/** Hash of the worker's code. */
export const version = '${createHash('sha256').update(code).digest('hex').slice(0, 16)}'

let address

/** Starts the worker. All workers share one Blob URL. */
export function startWorker() {
  address ??= URL.createObjectURL(new Blob([SOURCE], { type: 'text/javascript' }))
  return new Worker(address)
}
`
    },
  }
}
