import { createReadStream, mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import type { Readable } from 'node:stream'
import { fileURLToPath } from 'node:url'
import { createServer, type InlineConfig, type Plugin } from 'vite'
import type { facePacker } from './pack-faces.ts'

const moduleOf = (name: string) => fileURLToPath(new URL(name, import.meta.url))

/**
 * Serves generated files to tests in the browser, each made on first request:
 * - `/packed/NAME.glb`: faces of `pack-faces.ts`; `/packed/bare-faces.json` lists the bare ones
 * - `/damaged-faces.json`: files of `damaged-faces.ts`
 * - `/export-cases.json`: cases of `export-cases.ts`
 * - `/auto-digest.json`: digest computed in Node by `auto-digest.ts`
 *
 * @param sources resolution of the modules that make the files, in Node.
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
      serve('/auto-digest.json', async (faces) => {
        return JSON.stringify(await faces.autoDigest(readFileSync(join(root, 'faces/human.glb'))))
      })
      serve('/export-cases.json', async (faces) => {
        return JSON.stringify(await faces.exportCases(mkdtempSync(join(folder, 'export-'))))
      })
    },
  }
}

type Modules = typeof import('./pack-faces.ts') &
  typeof import('./damaged-faces.ts') &
  typeof import('./auto-digest.ts') &
  typeof import('./export-cases.ts')

type Sources = Pick<InlineConfig, 'resolve' | 'ssr'>

/** Uses a separate server, because Vitest's rewrites dynamic imports for the browser only. */
async function openModules(root: string, { resolve, ssr }: Sources): Promise<Modules> {
  const server = await createServer({
    root,
    configFile: false,
    resolve: { alias: resolve?.alias },
    ssr,
    optimizeDeps: { noDiscovery: true },
    server: { middlewareMode: true, hmr: false, ws: false, watch: null },
  })
  const modules = ['pack-faces.ts', 'damaged-faces.ts', 'export-cases.ts', 'auto-digest.ts'].map((name) =>
    server.ssrLoadModule(moduleOf(name)),
  )
  return Object.assign({}, ...(await Promise.all(modules)))
}
