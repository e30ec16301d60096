import { rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { Readable } from 'node:stream'
import type { ReadableStream } from 'node:stream/web'
import { FurrowError } from 'furrow'
import { cannotRead } from 'furrow-files'
import { download } from './download.ts'
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
    const { path, sha256 } = await get(address, tmpdir())
    await rm(path)
    return sha256
  },
  async fetch(address, identity, _, scratch) {
    const { path, sha256, tag } = await get(address, scratch)
    if (identity === sha256 || identity === `etag:${address}:${tag}`) return path
    await rm(path)
    throw changed(address)
  },
  async read(address) {
    return new Uint8Array(await (await request(address, 'GET')).arrayBuffer())
  },
  async put(address) {
    throw new FurrowError({
      code: 'unwritable',
      who: WHO,
      what: `cannot write to ${address}`,
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

async function get(address: string, scratch: string) {
  const response = await request(address, 'GET')
  const body = Readable.fromWeb((response.body ?? new Blob([]).stream()) as ReadableStream)
  const { path, sha256 } = await download(body, address, scratch).catch((error) => {
    throw error instanceof FurrowError ? error : cannotRead(WHO, address, error)
  })
  return { path, sha256, tag: response.headers.get('etag') }
}
