import { Readable } from 'node:stream'
import type { ReadableStream } from 'node:stream/web'
import { FurrowError } from 'furrow'
import { cannotRead, checkFileBytes } from 'furrow-files'
import { bytesOf, download, hashOf } from './download.ts'
import type { FileStore } from './file-store.ts'
import { changedInput } from './local-files.ts'

const WHO = 'furrow batch'

/** Time limit per request, milliseconds. */
const TIMEOUT = 300_000

/** Store of HTTP and HTTPS servers. Reads only. */
export const web: FileStore = {
  async identify(address) {
    const { headers } = await request(address, 'HEAD')
    const tag = headers.get('etag')
    // A weak ETag may stay equal when the content changes. The identity includes the address, because two servers may
    // use equal ETags.
    if (tag && !tag.startsWith('W/')) return `etag:${address}:${tag}`
    return withErrors(address, async () => hashOf((await get(address)).body, address))
  },
  async fetch(address, identity, _, scratch) {
    const { body, tag } = await get(address)
    const { path, sha256 } = await withErrors(address, () => download(body, address, scratch))
    if (identity === sha256 || identity === `etag:${address}:${tag}`) return path
    throw changedInput(address)
  },
  async read(address) {
    return withErrors(address, async () => bytesOf((await get(address)).body, address))
  },
  async put(address) {
    throw new FurrowError({
      code: 'unwritable',
      who: WHO,
      problem: `cannot write to ${address}`,
      limit: 'paths and s3:// URLs',
      remedy: 'choose another output',
    })
  },
  async sizeOf() {
    return undefined
  },
}

async function request(address: string, method: 'GET' | 'HEAD'): Promise<Response> {
  const response = await fetch(address, { method, signal: AbortSignal.timeout(TIMEOUT) }).catch((error) => {
    throw cannotRead(WHO, address, error.cause ?? error, { remedy: 'check the URL and the network' })
  })
  if (response.ok) return response
  const problem = Object.assign(new Error(`HTTP status ${response.status}`), {
    status: response.status,
  })
  throw cannotRead(WHO, address, problem, { remedy: 'check the URL' })
}

async function get(address: string) {
  const response = await request(address, 'GET')
  const { headers, body } = response
  // Throws before the download if the declared size is too large.
  checkFileBytes(Number(headers.get('content-length') ?? 0), address, WHO)
  const stream = Readable.fromWeb((body ?? new Blob([]).stream()) as ReadableStream)
  return { body: stream, tag: headers.get('etag') }
}

async function withErrors<T>(address: string, work: () => Promise<T>): Promise<T> {
  try {
    return await work()
  } catch (error) {
    throw error instanceof FurrowError ? error : cannotRead(WHO, address, error)
  }
}
