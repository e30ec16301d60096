import { once } from 'node:events'
import { createServer, STATUS_CODES } from 'node:http'
import type { AddressInfo } from 'node:net'
import { FurrowError } from 'furrow'
import { WebSocketServer } from 'ws'
import { type Access, statusOf } from './access.ts'

/** Maximum number of connected pages. */
const MAX_CLIENTS = 8

/** Maximum size of a message from a page in bytes. Pages have nothing to send. */
const MAX_MESSAGE = 1024

/** Bytes that may wait for a slow page. Frames above the limit are skipped for this page. */
const MAX_WAITING = 2 ** 18

export interface Bridge {
  readonly port: number
  /** Sends text to all pages. */
  send(text: string): void
  close(): void
}

/**
 * Starts a WebSocket server that sends text to pages. Ends a connection that sends anything.
 *
 * @param port TCP port; 0 for any free port.
 * @throws FurrowError if the port is not available.
 */
export async function startBridge({
  host,
  port,
  who,
  ...access
}: Access & { host: string; port: number; who: string }): Promise<Bridge> {
  const server = createServer((_, response) => response.writeHead(426).end())
  server.headersTimeout = 5000
  // Refused connections need a few more sockets for a short time.
  server.maxConnections = MAX_CLIENTS + 8
  const sockets = new WebSocketServer({ noServer: true, maxPayload: MAX_MESSAGE, perMessageDeflate: false })
  server.on('upgrade', (request, socket, head) => {
    socket.on('error', () => socket.destroy())
    const status = sockets.clients.size >= MAX_CLIENTS ? 503 : statusOf(request, access)
    if (status !== 101)
      return socket.end(`HTTP/1.1 ${status} ${STATUS_CODES[status]}\r\nConnection: close\r\n\r\n`)
    sockets.handleUpgrade(request, socket, head, (client) => {
      client.on('error', () => client.terminate())
      client.on('message', () => client.close(1008))
    })
  })
  try {
    server.listen(port, host)
    await once(server, 'listening')
  } catch (error) {
    throw new FurrowError(
      {
        code: 'unsupported',
        who,
        problem: 'cannot listen for pages',
        value: `${host}:${port}: ${(error as Error).message}`,
        remedy: 'choose another port with --port',
      },
      { cause: error },
    )
  }
  return {
    port: (server.address() as AddressInfo).port,
    send(text) {
      for (const client of sockets.clients) {
        if (client.readyState === client.OPEN && client.bufferedAmount < MAX_WAITING) client.send(text)
      }
    },
    close() {
      for (const client of sockets.clients) client.terminate()
      server.close()
      server.closeAllConnections()
    },
  }
}
