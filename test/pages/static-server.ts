import { createReadStream, existsSync, readFileSync, statSync } from 'node:fs'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { extname, join } from 'node:path'
import { fileURLToPath } from 'node:url'

const TYPES: Record<string, string> = {
  '.css': 'text/css',
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.png': 'image/png',
  '.wasm': 'application/wasm',
}

const REPOSITORY = fileURLToPath(new URL('../../', import.meta.url))

/**
 * Starts a static server for a folder, by default the repository's root.
 *
 * @param changeHtml edits the text of pages.
 */
export async function startStaticServer(
  root = REPOSITORY,
  changeHtml = (html: string) => html,
): Promise<{ origin: string; close(): void }> {
  const server = createServer((request, response) => {
    const file = join(root, decodeURIComponent(new URL(request.url ?? '/', 'http://localhost').pathname))
    // Browsers request an icon of every site.
    if (file.endsWith('favicon.ico')) return response.writeHead(204).end()
    if (!existsSync(file) || !statSync(file).isFile()) return response.writeHead(404).end()
    response.writeHead(200, { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream' })
    if (file.endsWith('.html')) return response.end(changeHtml(readFileSync(file, 'utf8')))
    return createReadStream(file).pipe(response)
  })
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve))
  return {
    origin: `http://127.0.0.1:${(server.address() as AddressInfo).port}`,
    close() {
      server.close()
      server.closeAllConnections()
    },
  }
}
