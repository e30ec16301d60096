import { createReadStream, mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { createServer, type InlineConfig, type Plugin } from 'vite'

const PACK = fileURLToPath(new URL('pack-faces.ts', import.meta.url))

/**
 * Serves the faces of `pack-faces.ts` at `/packed/NAME.glb`, each of which is packed when it is first asked for, and the
 * list of bare faces at `/packed/bare-faces.json`.
 *
 * @param ssr how the modules that pack are resolved, in Node.
 */
export function servePackedFaces(ssr: InlineConfig['ssr']): Plugin {
  return {
    name: 'furrow-packed-faces',
    configureServer({ middlewares, config: { root } }) {
      const folder = mkdtempSync(join(tmpdir(), 'furrow-faces-'))
      process.once('exit', () => rmSync(folder, { recursive: true, force: true }))
      let opened: ReturnType<typeof openPacker> | undefined
      middlewares.use('/packed', async ({ url = '' }, response, next) => {
        try {
          opened ??= openPacker(root, ssr, folder)
          const { faces, pathOf } = await opened
          if (url.startsWith('/bare-faces.json')) return void response.end(JSON.stringify(faces))
          const [, name] = /^\/([\w-]+)\.glb/.exec(url) ?? []
          createReadStream(await pathOf(name)).pipe(response)
        } catch (error) {
          next(error)
        }
      })
    },
  }
}

/** In a server of its own: Vitest's changes dynamic imports so that they work in the browser alone. */
async function openPacker(root: string, ssr: InlineConfig['ssr'], folder: string) {
  const server = await createServer({
    root,
    configFile: false,
    ssr,
    optimizeDeps: { noDiscovery: true },
    server: { middlewareMode: true, hmr: false, ws: false, watch: null },
  })
  const { BARE_FACES, facePacker } = await server.ssrLoadModule(PACK)
  return { faces: BARE_FACES, pathOf: facePacker(folder) as (name: string) => Promise<string> }
}
