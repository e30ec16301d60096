import { randomUUID } from 'node:crypto'
import { createReadStream } from 'node:fs'
import { createServer, type IncomingMessage, type ServerResponse } from 'node:http'
import type { AddressInfo } from 'node:net'
import { extname, join } from 'node:path'
import { buffer } from 'node:stream/consumers'
import { fileURLToPath, pathToFileURL } from 'node:url'

const PAGE_FOLDER = fileURLToPath(new URL('../page/', import.meta.url))

const MIME_TYPES: Record<string, string> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
}

/** Serves the page and the files that it needs, to this computer only, and receives its pictures. */
export interface LocalServer {
  /** The beginning of every address, without a slash at its end. */
  origin: string
  page: string
  /** Makes a file readable and returns its address; relative addresses in the file resolve as on disk. */
  offer(path: string): string
  /** Opens an address to which one picture can be posted. */
  inbox(): { address: string; received: () => Uint8Array | undefined }
  close(): Promise<void>
}

export async function startLocalServer(): Promise<LocalServer> {
  // Other programs on this computer can reach the port, but cannot guess the address.
  const secret = `/${randomUUID()}`
  const offered = new Map<string, string>()
  const inboxes = new Map<string, Uint8Array | undefined>()
  const server = createServer((request, response) => {
    const path = new URL(request.url ?? '/', 'http://localhost').pathname
    if (!path.startsWith(secret)) return refuse(response)
    const route = path.slice(secret.length)
    if (request.method === 'POST' && inboxes.has(route))
      return void receive(request, response, route, inboxes)
    const file = route.startsWith('/page/') ? join(PAGE_FOLDER, route.slice(6)) : offered.get(route)
    return file ? send(response, file) : refuse(response)
  })
  await new Promise<void>((ready, failed) => {
    server.once('error', failed)
    server.listen(0, '127.0.0.1', ready)
  })
  const origin = `http://127.0.0.1:${(server.address() as AddressInfo).port}${secret}`
  return {
    origin,
    page: `${origin}/page/index.html`,
    offer(path) {
      const route = `/file${pathToFileURL(path).pathname}`
      offered.set(route, path)
      return `${origin}${route}`
    },
    inbox() {
      const route = `/inbox/${inboxes.size}`
      inboxes.set(route, undefined)
      return { address: `${origin}${route}`, received: () => inboxes.get(route) }
    },
    close: () =>
      new Promise((closed) => {
        server.close(() => closed())
        server.closeAllConnections()
      }),
  }
}

function refuse(response: ServerResponse): void {
  response.writeHead(404).end()
}

async function receive(
  request: IncomingMessage,
  response: ServerResponse,
  route: string,
  inboxes: Map<string, Uint8Array | undefined>,
): Promise<void> {
  try {
    inboxes.set(route, await buffer(request))
    response.writeHead(204).end()
  } catch {
    response.destroy()
  }
}

function send(response: ServerResponse, file: string): void {
  const stream = createReadStream(file)
  stream.once('open', () => {
    response.writeHead(200, { 'content-type': MIME_TYPES[extname(file)] ?? 'application/octet-stream' })
    stream.pipe(response)
  })
  stream.once('error', () => (response.headersSent ? response.destroy() : refuse(response)))
}
