import { realpath } from 'node:fs/promises'
import type { RequestListener, Server } from 'node:http'
import { join, sep } from 'node:path'
import type { Plugin } from 'vite'

/** Prefix of URLs that contain the absolute path of a file. */
const FILES = '/@fs/'

/**
 * Restricts Vite's development server. Blocks the route that starts an editor, because Vite has no option for this. Blocks files outside
 * `folder`, even if a symbolic link leads to them. Answers malformed requests, which would otherwise stop the server. Add this plugin after
 * all plugins that rewrite URLs.
 */
export function guard(folder: string): Plugin {
  return {
    name: 'furrow-guard',
    async configureServer({ middlewares, httpServer }) {
      if (httpServer) refuseMalformed(httpServer as Server)
      // `node_modules` can be a symbolic link to another folder, which is then allowed too.
      const allowed = await Promise.all([folder, join(folder, 'node_modules')].map((path) => realpath(path)))
      middlewares.use('/__open-in-editor', (_, response) => response.writeHead(404).end())
      middlewares.use(async ({ url = '' }, response, next) => {
        if (!url.startsWith(FILES)) return next()
        const path = await realPathOf(url)
        const isAllowed = allowed.some((root) => `${path}${sep}`.startsWith(`${root}${sep}`))
        // Let Vite answer requests for missing files. It generates some of them on demand.
        if (path === undefined || isAllowed) return next()
        response.writeHead(404).end()
      })
    },
  }
}

/** Answers 400 to malformed URLs such as `http://[`, which make Connect throw before it calls any middleware. */
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

/** Returns the path of a URL's file after following symbolic links, or undefined if there is no such file. */
async function realPathOf(url: string): Promise<string | undefined> {
  try {
    const path = decodeURIComponent(url.split('?')[0])
    // On Windows, a drive letter follows the prefix. Elsewhere, the last slash of the prefix begins the path.
    return await realpath(path.slice(sep === '/' ? FILES.length - 1 : FILES.length))
  } catch {
    return undefined
  }
}
