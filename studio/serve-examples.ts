import { readdir, readFile } from 'node:fs/promises'
import { join } from 'node:path'
import type { Plugin } from 'vite'

/** Serves `/examples/NAME.html` beside the studio in development. */
export function serveExamples(folder: string): Plugin {
  return {
    name: 'furrow-examples',
    // An inline script is a virtual module, so resolve its relative imports against the examples folder.
    resolveId(source, importer) {
      return source.startsWith('./') && importer?.includes('/examples/') && importer.includes('html-proxy')
        ? join(folder, source)
        : null
    },
    configureServer(server) {
      server.middlewares.use(async (request, response, next) => {
        const path = (request.url ?? '/').split('?')[0]
        if (!path.startsWith('/examples/')) return next()
        if (!path.endsWith('.html')) {
          request.url = `/@fs${join(folder, request.url!.slice('/examples/'.length))}`
          return next()
        }
        try {
          const pages = await readdir(folder, { withFileTypes: true })
          const page = pages.find((entry) => entry.isFile() && `/examples/${entry.name}` === path)
          if (!page) {
            response.writeHead(404).end()
            return
          }
          const source = await readFile(join(folder, page.name), 'utf8')
          response.setHeader('Content-Type', 'text/html')
          response.end(await server.transformIndexHtml(path, source))
        } catch (error) {
          next(error)
        }
      })
    },
  }
}
