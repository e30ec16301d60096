import { realpath } from 'node:fs/promises'
import type { RequestListener, Server } from 'node:http'
import { join, sep } from 'node:path'
import type { Plugin } from 'vite'

/** Where Vite serves files by their paths. */
const FILES = '/@fs/'

/**
 * Closes what Vite's server exposes besides the studio: the route that starts an editor, for which it has no option, and
 * files outside a folder to which links inside it lead. No request ends the server. Comes after all plugins that change
 * addresses.
 */
export function guard(folder: string): Plugin {
  return {
    name: 'furrow-guard',
    async configureServer({ middlewares, httpServer }) {
      if (httpServer) refuseMalformed(httpServer as Server)
      // The dependencies may be a link.
      const allowed = await Promise.all([folder, join(folder, 'node_modules')].map((path) => realpath(path)))
      middlewares.use('/__open-in-editor', (_, response) => response.writeHead(404).end())
      middlewares.use(async ({ url = '' }, response, next) => {
        if (!url.startsWith(FILES)) return next()
        const path = await realPathOf(url)
        const isAllowed = allowed.some((root) => `${path}${sep}`.startsWith(`${root}${sep}`))
        // Vite makes some files only when they are asked for, and does not follow what is not there.
        if (path === undefined || isAllowed) return next()
        response.writeHead(404).end()
      })
    },
  }
}

/** Connect parses an address such as `http://[` before any middleware, and throws. */
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

/** The file that an address means once all links are followed; undefined where there is none. */
async function realPathOf(url: string): Promise<string | undefined> {
  try {
    const path = decodeURIComponent(url.split('?')[0])
    // On Windows a drive follows.
    return await realpath(path.slice(sep === '/' ? FILES.length - 1 : FILES.length))
  } catch {
    return undefined
  }
}
