import { createHash } from 'node:crypto'
import { createWriteStream } from 'node:fs'
import { join } from 'node:path'
import type { Readable } from 'node:stream'
import { pipeline } from 'node:stream/promises'
import { checkFileBytes } from 'furrow-files'

let downloads = 0

/**
 * Writes a stream to a new file of a folder.
 *
 * @returns its path, and the hash of its bytes.
 * @throws FurrowError where it is larger than a file that is read may be.
 */
export async function download(
  stream: Readable,
  address: string,
  scratch: string,
): Promise<{ path: string; sha256: string }> {
  const extension = /\.(glb|vrm)$/i.exec(new URL(address).pathname)?.[0] ?? '.glb'
  const path = join(scratch, `input-${++downloads}${extension}`)
  const hash = createHash('sha256')
  let length = 0
  async function* checked(chunks: AsyncIterable<Buffer>) {
    for await (const chunk of chunks) {
      length += chunk.length
      checkFileBytes(length, address, 'furrow batch')
      hash.update(chunk)
      yield chunk
    }
  }
  await pipeline(stream, checked, createWriteStream(path))
  return { path, sha256: `sha256:${hash.digest('hex')}` }
}
