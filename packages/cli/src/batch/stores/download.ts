import { createHash } from 'node:crypto'
import { createWriteStream } from 'node:fs'
import { join } from 'node:path'
import type { Readable } from 'node:stream'
import { pipeline } from 'node:stream/promises'
import { checkFileBytes } from 'furrow-files'

/**
 * Writes a stream to a new file in a folder.
 *
 * @param folder folder of one job. The caller removes it, also after errors.
 * @returns path of the file and hash of its bytes.
 * @throws FurrowError if the stream exceeds the size limit of input files.
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

/** Returns the hash of a stream's bytes, in the format of `download`. */
export async function hashOf(stream: Readable, address: string): Promise<string> {
  const hash = createHash('sha256')
  for await (const chunk of limited(stream, address)) hash.update(chunk)
  return `sha256:${hash.digest('hex')}`
}

export async function bytesOf(stream: Readable, address: string): Promise<Uint8Array> {
  const chunks: Buffer[] = []
  for await (const chunk of limited(stream, address)) chunks.push(chunk)
  return Buffer.concat(chunks)
}

/** Yields the chunks of a stream. Throws if they exceed the size limit, even if a header declared a smaller size. */
async function* limited(chunks: AsyncIterable<Buffer>, address: string): AsyncGenerator<Buffer> {
  let length = 0
  for await (const chunk of chunks) {
    length += chunk.length
    checkFileBytes(length, address, 'furrow batch')
    yield chunk
  }
}
