import { randomUUID } from 'node:crypto'
import { createReadStream } from 'node:fs'
import { createServer, type IncomingMessage, type ServerResponse } from 'node:http'
import type { AddressInfo } from 'node:net'
import { extname, join } from 'node:path'
import { buffer } from 'node:stream/consumers'
import { fileURLToPath, pathToFileURL } from 'node:url'

const PAGE_FOLDER = fileURLToPath(new URL('../page/', import.meta.url))

const TYPES: Record<string, string> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
}

/** Serves the page and the files it was promised, to this computer alone, and takes its pictures. */
export interface LocalServer {
  /** Begins every address; ends without a slash. */
  origin: string
  page: string
  /** Allows a file to be read; addresses within it resolve as they do on disk. */
  offer(path: string): string
  /** A place to post one picture to. */
  inbox(): { address: string; received: () => Uint8Array | undefined }
  close(): Promise<void>
}

export async function startLocalServer(): Promise<LocalServer> {
  // Other programs on this computer can reach the port, but cannot guess this.
  const secret = `/${randomUUID()}`
  const offered = new Map<string, string>()
  const inboxes = new Map<string, Uint8Array | undefined>()
  const server = createServer((request, response) => {
    const path = new URL(request.url ?? '/', 'http://localhost').pathname
    if (!path.startsWith(secret)) return refuse(response)
    const place = path.slice(secret.length)
    if (request.method === 'POST' && inboxes.has(place)) return void take(request, response, place, inboxes)
    const file = place.startsWith('/page/') ? join(PAGE_FOLDER, place.slice(6)) : offered.get(place)
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
      const place = `/file${pathToFileURL(path).pathname}`
      offered.set(place, path)
      return `${origin}${place}`
    },
    inbox() {
      const place = `/inbox/${inboxes.size}`
      inboxes.set(place, undefined)
      return { address: `${origin}${place}`, received: () => inboxes.get(place) }
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

async function take(
  request: IncomingMessage,
  response: ServerResponse,
  place: string,
  inboxes: Map<string, Uint8Array | undefined>,
): Promise<void> {
  try {
    inboxes.set(place, await buffer(request))
    response.writeHead(204).end()
  } catch {
    response.destroy()
  }
}

function send(response: ServerResponse, file: string): void {
  const stream = createReadStream(file)
  stream.once('open', () => {
    response.writeHead(200, { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream' })
    stream.pipe(response)
  })
  stream.once('error', () => (response.headersSent ? response.destroy() : refuse(response)))
}
