import { timingSafeEqual } from 'node:crypto'
import type { IncomingMessage } from 'node:http'

/** Pages that may connect without `--origin`: those of a server on this computer. */
const LOCAL = /^https?:\/\/(localhost|127\.0\.0\.1|\[::1\])(:\d+)?$/

/** Rules that a connection must meet. */
export interface Access {
  /** Origins of further pages, such as `https://example.com`. */
  origins: readonly string[]
  token: string
}

/**
 * Returns the HTTP status of a request for a connection: 101 if it is allowed. Browsers always send the origin of the page. Programs without
 * an origin need only the token.
 */
export function statusOf(
  { headers, url = '' }: IncomingMessage,
  { origins, token }: Access,
): 101 | 401 | 403 {
  const { origin } = headers
  if (origin !== undefined && !LOCAL.test(origin) && !origins.includes(origin)) return 403
  const given = new URLSearchParams(url.slice(url.indexOf('?') + 1)).get('token') ?? ''
  return isEqual(given, token) ? 101 : 401
}

/** Compares texts in a time that does not depend on where they differ. */
function isEqual(a: string, b: string): boolean {
  const [first, second] = [Buffer.from(a), Buffer.from(b)]
  return first.length === second.length && timingSafeEqual(first, second)
}
