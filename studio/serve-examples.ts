import { readFile } from 'node:fs/promises'
import { basename, join } from 'node:path'
import type { Plugin } from 'vite'

/** Serves `/examples/NAME.html` beside the studio in development. */
export function serveExamples(folder: string): Plugin {
  return {
    name: 'furrow-examples',
    // An inline script is a virtual module, so its relative imports are resolved against the examples folder.
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
          const page = await readFile(join(folder, basename(path)), 'utf8')
          response.setHeader('Content-Type', 'text/html')
          response.end(await server.transformIndexHtml(path, page))
        } catch (error) {
          next(error)
        }
      })
    },
  }
}
