import { randomUUID } from 'node:crypto'
import { createReadStream, readdirSync } from 'node:fs'
import { createServer, type IncomingMessage, type ServerResponse } from 'node:http'
import type { AddressInfo } from 'node:net'
import { extname, join, relative, sep } from 'node:path'
import { pipeline } from 'node:stream'
import { buffer } from 'node:stream/consumers'
import { fileURLToPath, pathToFileURL } from 'node:url'

const PAGE_FOLDER = fileURLToPath(new URL('../page/', import.meta.url))

const MIME_TYPES: Record<string, string> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
}

/**
 * Server on localhost for the page that draws images. Serves the page and the files that it loads, and receives pixels.
 */
export interface LocalServer {
  /** Prefix of all URLs, without a trailing slash. */
  origin: string
  page: string
  /** Returns the URL of a file. Relative URLs in the file resolve as on disk. */
  addressOf(path: string): string
  /** Lets the page read a file. `content` is its bytes, or the path to read them from. */
  offer(path: string, content: Uint8Array | string): void
  /** Creates a URL to which `length` bytes can be posted once. `received` returns the posted bytes. */
  inbox(length: number): { address: string; received: () => Uint8Array | undefined }
  close(): Promise<void>
}

interface Inbox {
  length: number
  bytes?: Uint8Array
}

/** @param pageFolder folder that contains `index.html` of the page. */
export async function startLocalServer(pageFolder = PAGE_FOLDER): Promise<LocalServer> {
  // Other programs on this machine can connect to the port, but cannot guess this part of the URL.
  const secret = `/${randomUUID()}`
  const contents = pageFiles(pageFolder)
  const inboxes = new Map<string, Inbox>()
  let host: string
  const server = createServer((request, response) => {
    // A client can disconnect at any time.
    for (const stream of [request, response]) stream.on('error', () => response.destroy())
    // Protects against DNS rebinding, where a web page makes its host name resolve to this machine.
    if (request.headers.host !== host) return answer(response, 403)
    const path = request.url?.split('?', 1)[0] ?? ''
    if (!path.startsWith(`${secret}/`)) return answer(response, 404)
    const route = path.slice(secret.length)
    const [content, inbox] = [contents.get(route), inboxes.get(route)]
    if (content && request.method === 'GET') return send(response, route, content)
    if (inbox && request.method === 'POST') return void receive(request, response, inbox)
    answer(response, content || inbox ? 405 : 404)
  })
  await new Promise<void>((ready, failed) => {
    server.on('error', failed)
    server.listen(0, '127.0.0.1', ready)
  })
  host = `127.0.0.1:${(server.address() as AddressInfo).port}`
  const origin = `http://${host}${secret}`
  return {
    origin,
    page: `${origin}/page/index.html`,
    addressOf: (path) => `${origin}${routeOf(path)}`,
    offer: (path, content) => void contents.set(routeOf(path), content),
    inbox(length) {
      const route = `/inbox/${inboxes.size}`
      const inbox: Inbox = { length }
      inboxes.set(route, inbox)
      return { address: `${origin}${route}`, received: () => inbox.bytes }
    },
    close: () =>
      new Promise((closed) => {
        server.close(() => closed())
        server.closeAllConnections()
      }),
  }
}

function routeOf(path: string): string {
  return `/file${pathToFileURL(path).pathname}`
}

/** Returns the files of the page by route. The server serves other files only after `offer`. */
function pageFiles(folder: string): Map<string, Uint8Array | string> {
  const files = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((file) => file.isFile())
  return new Map(
    files.map(({ parentPath, name }) => {
      const path = join(parentPath, name)
      return [`/page/${relative(folder, path).split(sep).join('/')}`, path]
    }),
  )
}

function answer(response: ServerResponse, status: number): void {
  // Closes the connection, because the rest of the request is not read.
  response.writeHead(status, { connection: 'close' }).end()
}

/** Receives a body with exactly the expected length, once. */
async function receive(request: IncomingMessage, response: ServerResponse, inbox: Inbox): Promise<void> {
  if (inbox.bytes) return answer(response, 409)
  // Node never reads more than `content-length` bytes.
  if (Number(request.headers['content-length']) !== inbox.length) return answer(response, 413)
  try {
    inbox.bytes = await buffer(request)
    answer(response, 204)
  } catch {
    response.destroy()
  }
}

function send(response: ServerResponse, route: string, content: Uint8Array | string): void {
  const headers = { 'content-type': MIME_TYPES[extname(route)] ?? 'application/octet-stream' }
  if (typeof content !== 'string') return void response.writeHead(200, headers).end(content)
  const stream = createReadStream(content)
  stream.once('open', () => {
    response.writeHead(200, headers)
    pipeline(stream, response, () => {})
  })
  stream.once('error', () => (response.headersSent ? response.destroy() : answer(response, 404)))
}
