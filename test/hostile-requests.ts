import { connect } from 'node:net'
import { seeded } from './random.ts'

/** Malformed paths, and paths outside the served folders. */
export const HOSTILE_PATHS: readonly string[] = [
  '//',
  '///',
  '/%',
  '/%00',
  '/%E0%A4%A',
  '/\\..\\..\\package.json',
  '/../package.json',
  '/..%2Fpackage.json',
  '/%2e%2e/package.json',
  '//etc/passwd',
  '/etc/passwd',
  '?',
  '*',
  'http://[',
  'http://elsewhere.example/',
  'https://user:secret@elsewhere.example/%',
  'file:///etc/passwd',
  `/${'a/'.repeat(5000)}`,
  `/${'../'.repeat(2000)}etc/passwd`,
  `/${'a'.repeat(100_000)}`,
]

/** Invalid or incomplete HTTP requests. Each is sent on its own connection, which then ends. */
export const HOSTILE_BYTES: readonly (string | Uint8Array)[] = [
  '',
  '\r\n\r\n',
  'GET',
  'GET / HTTP/9.9\r\n\r\n',
  'GET / HTTP/1.1\r\n\r\n',
  'GET  / HTTP/1.1\r\nHost:\r\n\r\n',
  'FOO BAR\r\n\r\n',
  'GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n',
  'GET / HTTP/1.1\r\nHost: \u0000\r\n\r\n',
  'POST / HTTP/1.1\r\nHost: a\r\nContent-Length: -1\r\n\r\n',
  'POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 5\r\nContent-Length: 6\r\n\r\nabc',
  'POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 5\r\nTransfer-Encoding: chunked\r\n\r\nabc',
  'POST / HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\n\r\nzz\r\n',
  'POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 99999999999\r\nExpect: 100-continue\r\n\r\n',
  'CONNECT / HTTP/1.1\r\nHost: a\r\n\r\n',
  'TRACE / HTTP/1.1\r\nHost: a\r\n\r\n',
  'GET / HTTP/1.1\r\nHost: a\r\nRange: bytes=-99999999999999999999\r\nConnection: close\r\n\r\n',
  `GET / HTTP/1.1\r\nHost: a\r\nX: ${'y'.repeat(100_000)}\r\n\r\n`,
  // TLS client hello.
  Uint8Array.from([0x16, 0x03, 0x01, 0x02, 0x00, 0x01, 0x00, 0x01, 0xfc, 0x03, 0x03]),
  ...Array.from({ length: 20 }, (_, seed) => {
    const next = seeded(seed)
    return Uint8Array.from({ length: 1 + Math.floor(2000 * next()) }, () => 256 * next())
  }),
]

/** Sends a request and returns the complete response. The path is sent unchanged; `fetch` would normalise it. */
export function request(
  origin: string,
  path: string,
  { method = 'GET', host = new URL(origin).host, body = '' } = {},
): Promise<string> {
  const length = body ? `Content-Length: ${Buffer.byteLength(body)}\r\n` : ''
  return exchange(
    origin,
    `${method} ${path} HTTP/1.1\r\nHost: ${host}\r\n${length}Connection: close\r\n\r\n${body}`,
    false,
  )
}

/** Sends bytes, ends the connection, and returns the response. */
export function send(origin: string, bytes: string | Uint8Array): Promise<string> {
  return exchange(origin, bytes, true)
}

export function statusOf(response: string): number {
  return Number(/^HTTP\/1\.1 (\d+)/.exec(response)?.[1])
}

function exchange(origin: string, bytes: string | Uint8Array, ends: boolean): Promise<string> {
  const { hostname, port } = new URL(origin)
  return new Promise((resolve) => {
    const parts: Buffer[] = []
    const socket = connect(Number(port), hostname, () => (ends ? socket.end(bytes) : socket.write(bytes)))
    socket.on('data', (part) => parts.push(part))
    // A server may close the connection before it has read everything.
    socket.on('error', () => {})
    socket.on('close', () => resolve(Buffer.concat(parts).toString('latin1')))
  })
}
