import { createReadStream, mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { Readable } from 'node:stream'
import { fileURLToPath } from 'node:url'
import { createServer, type InlineConfig, type Plugin } from 'vite'
import type { facePacker } from './pack-faces.ts'

const moduleOf = (name: string) => fileURLToPath(new URL(name, import.meta.url))

/**
 * Vite plugin that serves generated files to tests in the browser. It makes each file on the first request:
 * - `/packed/NAME.glb`: faces of `pack-faces.ts`; `/packed/bare-faces.json` lists those without wrinkles
 * - `/damaged-faces.json`: files of `damaged-faces.ts`
 * - `/export-cases.json`: cases of `export-cases.ts`
 * - `/small-head.glb`: face of `small-head.ts`
 * - `/auto-digests.json`: hashes computed in Node by `auto-digest.ts`
 *
 * @param sources Vite options that resolve the repository's packages to their sources, for the modules that make the files.
 */
export function serveFaces(sources: Sources): Plugin {
  return {
    name: 'furrow-faces',
    configureServer({ middlewares, config: { root } }) {
      const folder = mkdtempSync(join(tmpdir(), 'furrow-faces-'))
      process.once('exit', () => rmSync(folder, { recursive: true, force: true }))
      let opened: ReturnType<typeof openModules> | undefined
      let packer: ReturnType<typeof facePacker> | undefined
      const serve = (path: string, answer: (faces: Modules, url: string) => Promise<string | Readable>) =>
        middlewares.use(path, async ({ url = '' }, response, next) => {
          try {
            opened ??= openModules(root, sources)
            const content = await answer(await opened, url)
            if (typeof content === 'string') response.end(content)
            else content.pipe(response)
          } catch (error) {
            next(error)
          }
        })
      serve('/packed', async (faces, url) => {
        if (url.startsWith('/bare-faces.json')) return JSON.stringify(faces.BARE_FACES)
        const [, name] = /^\/([\w-]+)\.glb/.exec(url) ?? []
        packer ??= faces.facePacker(folder)
        return createReadStream(await packer(name))
      })
      serve('/damaged-faces.json', async (faces) => JSON.stringify(await faces.damagedFaces()))
      let small: Promise<Uint8Array> | undefined
      const smallHead = (faces: Modules) => {
        small ??= faces.smallHead(join(root, 'faces/human.glb'))
        return small
      }
      serve('/small-head.glb', async (faces) => Readable.from([await smallHead(faces)]))
      serve('/auto-digests.json', async (faces) => {
        const human = readFileSync(join(root, 'faces/human.glb'))
        return JSON.stringify({
          'human.glb': await faces.autoDigest('human.glb', human),
          'small-head.glb': await faces.autoDigest('small-head.glb', await smallHead(faces)),
        })
      })
      serve('/export-cases.json', async (faces) => {
        return JSON.stringify(await faces.exportCases(mkdtempSync(join(folder, 'export-'))))
      })
    },
  }
}

type Modules = typeof import('./pack-faces.ts') &
  typeof import('./damaged-faces.ts') &
  typeof import('../auto-digest.ts') &
  typeof import('../small-head.ts') &
  typeof import('./export-cases.ts')

type Sources = Pick<InlineConfig, 'resolve' | 'ssr'>

/** Loads the modules by a separate Vite server, because the server of Vitest rewrites dynamic imports for browsers. */
async function openModules(root: string, { resolve, ssr }: Sources): Promise<Modules> {
  const server = await createServer({
    root,
    configFile: false,
    resolve: { alias: resolve?.alias },
    ssr,
    optimizeDeps: { noDiscovery: true },
    server: { middlewareMode: true, hmr: false, ws: false, watch: null },
  })
  const names = [
    'pack-faces.ts',
    'damaged-faces.ts',
    'export-cases.ts',
    '../auto-digest.ts',
    '../small-head.ts',
  ]
  const modules = names.map((name) => server.ssrLoadModule(moduleOf(name)))
  return Object.assign({}, ...(await Promise.all(modules)))
}
