import { Readable } from 'node:stream'
import type { ReadableStream } from 'node:stream/web'
import { FurrowError } from 'furrow'
import { cannotRead, checkFileBytes } from 'furrow-files'
import { bytesOf, download, hashOf } from './download.ts'
import { changed } from './files.ts'
import type { Place } from './place.ts'

const WHO = 'furrow batch'

/** Milliseconds for one file. */
const TIMEOUT = 300_000

/** http and https: inputs alone. */
export const web: Place = {
  async identify(address) {
    const { headers } = await request(address, 'HEAD')
    const tag = headers.get('etag')
    // A weak tag may stay where bytes change. Tags of two servers can be the same text.
    if (tag && !tag.startsWith('W/')) return `etag:${address}:${tag}`
    return withErrors(address, async () => hashOf((await get(address)).body, address))
  },
  async fetch(address, identity, _, scratch) {
    const { body, tag } = await get(address)
    const { path, sha256 } = await withErrors(address, () => download(body, address, scratch))
    if (identity === sha256 || identity === `etag:${address}:${tag}`) return path
    throw changed(address)
  },
  async read(address) {
    return withErrors(address, async () => bytesOf((await get(address)).body, address))
  },
  async put(address) {
    throw new FurrowError({
      code: 'unwritable',
      who: WHO,
      problem: `cannot write to ${address}`,
      limit: 'paths and s3 addresses',
      remedy: 'name another output',
    })
  },
  async sizeOf() {
    return undefined
  },
}

async function request(address: string, method: 'GET' | 'HEAD'): Promise<Response> {
  const response = await fetch(address, { method, signal: AbortSignal.timeout(TIMEOUT) }).catch((error) => {
    throw cannotRead(WHO, address, error.cause ?? error, { remedy: 'check the address and the network' })
  })
  if (response.ok) return response
  const problem = Object.assign(new Error(`the server answers ${response.status}`), {
    status: response.status,
  })
  throw cannotRead(WHO, address, problem, { remedy: 'check the address' })
}

async function get(address: string) {
  const response = await request(address, 'GET')
  const { headers, body } = response
  // A server that tells the size is spared the download.
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
