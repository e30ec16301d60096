import { setTimeout as sleep } from 'node:timers/promises'

/** Delays before the second and the third attempt, milliseconds. */
const DELAYS = [1000, 5000]

/** Error codes of transient faults of the system and the network. */
const CODES = new Set(
  (
    'EAGAIN EBUSY EIO EMFILE ENFILE ENOBUFS ESTALE ETIMEDOUT ECONNRESET ECONNREFUSED ECONNABORTED EPIPE EAI_AGAIN ' +
    'EHOSTUNREACH ENETUNREACH ENETDOWN UND_ERR_SOCKET UND_ERR_CONNECT_TIMEOUT UND_ERR_HEADERS_TIMEOUT UND_ERR_BODY_TIMEOUT'
  ).split(' '),
)

/** Returns whether an HTTP status is transient: a timeout, a rate limit or a server error. */
const isTransientStatus = (status: number) => status === 408 || status === 429 || status >= 500

interface Failure {
  code?: string
  name?: string
  cause?: unknown
  status?: number
  $metadata?: { httpStatusCode?: number }
}

export function isTransient(error: unknown): boolean {
  if (typeof error !== 'object' || error === null) return false
  const { code, name, cause, status, $metadata } = error as Failure
  const answer = status ?? $metadata?.httpStatusCode
  if (answer !== undefined) return isTransientStatus(answer)
  return (
    (code !== undefined && CODES.has(code)) ||
    name === 'TimeoutError' ||
    (cause !== undefined && isTransient(cause))
  )
}

/** Runs `work`. Repeats it up to twice if it fails with a transient error. */
export async function withRetries<T>(work: () => Promise<T>, delays: readonly number[] = DELAYS): Promise<T> {
  for (const delay of delays) {
    try {
      return await work()
    } catch (error) {
      if (!isTransient(error)) throw error
      await sleep(delay)
    }
  }
  return work()
}
