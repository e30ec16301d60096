import { realpath } from 'node:fs/promises'
import type { RequestListener, Server } from 'node:http'
import { join, sep } from 'node:path'
import type { Plugin } from 'vite'

/** URL prefix of files served by path. */
const FILES = '/@fs/'

/**
 * Restricts Vite's development server: blocks the route that starts an editor, for which Vite has no option, and files outside the folder
 * that are reachable through symbolic links. Malformed requests do not stop the server. Add this plugin last, after all plugins that
 * rewrite URLs.
 */
export function guard(folder: string): Plugin {
  return {
    name: 'furrow-guard',
    async configureServer({ middlewares, httpServer }) {
      if (httpServer) refuseMalformed(httpServer as Server)
      // node_modules can be a symbolic link.
      const allowed = await Promise.all([folder, join(folder, 'node_modules')].map((path) => realpath(path)))
      middlewares.use('/__open-in-editor', (_, response) => response.writeHead(404).end())
      middlewares.use(async ({ url = '' }, response, next) => {
        if (!url.startsWith(FILES)) return next()
        const path = await realPathOf(url)
        const isAllowed = allowed.some((root) => `${path}${sep}`.startsWith(`${root}${sep}`))
        // Vite creates some files on demand, and does not follow missing ones.
        if (path === undefined || isAllowed) return next()
        response.writeHead(404).end()
      })
    },
  }
}

/** Answers 400 to malformed URLs such as `http://[`, which make Connect throw before any middleware. */
function refuseMalformed(server: Server): void {
  const listeners = server.listeners('request') as RequestListener[]
  server.removeAllListeners('request')
  server.on('request', (request, response) => {
    try {
      for (const listener of listeners) listener.call(server, request, response)
    } catch {
      response.writeHead(400).end()
    }
  })
}

/** Resolves a URL to a file, following symbolic links. Returns undefined if there is none. */
async function realPathOf(url: string): Promise<string | undefined> {
  try {
    const path = decodeURIComponent(url.split('?')[0])
    // On Windows, the drive letter follows.
    return await realpath(path.slice(sep === '/' ? FILES.length - 1 : FILES.length))
  } catch {
    return undefined
  }
}
