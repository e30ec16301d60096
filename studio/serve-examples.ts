import { readdir, readFile } from 'node:fs/promises'
import { join } from 'node:path'
import type { Plugin } from 'vite'

/** Makes the studio's development server also serve the example pages, as `/examples/NAME.html`. */
export function serveExamples(folder: string): Plugin {
  return {
    name: 'furrow-examples',
    // Vite turns an inline script into a virtual module, which has no folder. Resolve its relative imports in the examples folder.
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
