import { createHash } from 'node:crypto'
import { createWriteStream } from 'node:fs'
import { join } from 'node:path'
import type { Readable } from 'node:stream'
import { pipeline } from 'node:stream/promises'
import { checkFileBytes } from 'furrow-files'

/**
 * Writes a stream to a new file of a folder.
 *
 * @param folder of one job: it is removed with the file, also where this fails.
 * @returns its path, and the hash of its bytes.
 * @throws FurrowError where it is larger than a file that is read may be.
 */
export async function download(
  stream: Readable,
  address: string,
  folder: string,
): Promise<{ path: string; sha256: string }> {
  const extension = /\.(glb|vrm)$/i.exec(new URL(address).pathname)?.[0] ?? '.glb'
  const path = join(folder, `input${extension}`)
  const hash = createHash('sha256')
  async function* hashed(chunks: AsyncIterable<Buffer>) {
    for await (const chunk of limited(chunks, address)) {
      hash.update(chunk)
      yield chunk
    }
  }
  await pipeline(stream, hashed, createWriteStream(path))
  return { path, sha256: `sha256:${hash.digest('hex')}` }
}

/** The hash of the bytes of a stream, as `download` tells it. */
export async function hashOf(stream: Readable, address: string): Promise<string> {
  const hash = createHash('sha256')
  for await (const chunk of limited(stream, address)) hash.update(chunk)
  return `sha256:${hash.digest('hex')}`
}

/** The bytes of a stream. */
export async function bytesOf(stream: Readable, address: string): Promise<Uint8Array> {
  const chunks: Buffer[] = []
  for await (const chunk of limited(stream, address)) chunks.push(chunk)
  return Buffer.concat(chunks)
}

/** The chunks of a stream. Throws FurrowError where it is larger than a file that is read may be, whatever it said before. */
async function* limited(chunks: AsyncIterable<Buffer>, address: string): AsyncGenerator<Buffer> {
  let length = 0
  for await (const chunk of chunks) {
    length += chunk.length
    checkFileBytes(length, address, 'furrow batch')
    yield chunk
  }
}
