/** Whether to try again, and when. */

import { setTimeout as sleep } from 'node:timers/promises'

/** Milliseconds before the second and the third attempt. */
const PAUSES = [1000, 5000]

/** Codes of errors of the system and of connections that can be gone a moment later. */
const CODES = new Set(
  (
    'EAGAIN EBUSY EIO EMFILE ENFILE ENOBUFS ESTALE ETIMEDOUT ECONNRESET ECONNREFUSED ECONNABORTED EPIPE EAI_AGAIN ' +
    'EHOSTUNREACH ENETUNREACH ENETDOWN UND_ERR_SOCKET UND_ERR_CONNECT_TIMEOUT UND_ERR_HEADERS_TIMEOUT UND_ERR_BODY_TIMEOUT'
  ).split(' '),
)

/** Answers of a server that asks for patience, or is broken for now. */
const STATUSES = (status: number) => status === 408 || status === 429 || status >= 500

interface Failure {
  code?: string
  name?: string
  cause?: unknown
  status?: number
  $metadata?: { httpStatusCode?: number }
}

/** Whether what failed can succeed a moment later, with nothing changed: its error, or one of its causes. */
export function canPass(error: unknown): boolean {
  if (typeof error !== 'object' || error === null) return false
  const { code, name, cause, status, $metadata } = error as Failure
  const answer = status ?? $metadata?.httpStatusCode
  if (answer !== undefined) return STATUSES(answer)
  return (
    (code !== undefined && CODES.has(code)) ||
    name === 'TimeoutError' ||
    (cause !== undefined && canPass(cause))
  )
}

/** Does some work up to three times, as long as it fails for what can pass. */
export async function patiently<T>(work: () => Promise<T>, pauses: readonly number[] = PAUSES): Promise<T> {
  for (const pause of pauses) {
    try {
      return await work()
    } catch (error) {
      if (!canPass(error)) throw error
      await sleep(pause)
    }
  }
  return work()
}
