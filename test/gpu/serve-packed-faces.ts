import { createReadStream, mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import type { Plugin } from 'vite'

const PACK = fileURLToPath(new URL('pack-faces.ts', import.meta.url))

/**
 * Serves the faces of `pack-faces.ts` at `/packed/NAME.glb`, each of which is packed when it is first asked for, and the
 * list of bare faces at `/packed/bare-faces.json`.
 */
export function servePackedFaces(): Plugin {
  return {
    name: 'furrow-packed-faces',
    configureServer(server) {
      let folder = ''
      const open = async () => {
        folder = mkdtempSync(join(tmpdir(), 'furrow-faces-'))
        const { BARE_FACES, facePacker } = await server.ssrLoadModule(PACK)
        return { faces: BARE_FACES, pathOf: facePacker(folder) as (name: string) => Promise<string> }
      }
      let opened: ReturnType<typeof open> | undefined
      server.middlewares.use('/packed', async ({ url = '' }, response, next) => {
        try {
          opened ??= open()
          const { faces, pathOf } = await opened
          if (url.startsWith('/bare-faces.json')) return void response.end(JSON.stringify(faces))
          const [, name] = /^\/([\w-]+)\.glb/.exec(url) ?? []
          createReadStream(await pathOf(name)).pipe(response)
        } catch (error) {
          next(error)
        }
      })
      process.once('exit', () => folder && rmSync(folder, { recursive: true, force: true }))
    },
  }
}
