import { type FileHandle, open } from 'node:fs/promises'
import { FurrowError } from 'furrow'
import { cannotRead } from '../base/errors.ts'
import { HEAD_BYTES } from '../base/file-kind.ts'
import { checkFileBytes, MAX_FILE_BYTES, MAX_JSON_BYTES } from '../base/file-size.ts'
import { parseJson } from '../base/json-file.ts'
import { fileProblem, statOf } from './file-status.ts'
import { recordRead } from './files-read.ts'

/** What the shell has opened, as in `furrow inspect <(...)`. Other pipes may have no writer, and devices no end. */
const OPEN_FILE = /^\/(dev\/stdin|(dev|proc\/self)\/fd\/\d+)$/

/** How a file is read. */
export interface ReadRules {
  /** Most bytes of it. */
  most?: number
  /** Is given the first bytes of a file and its size, before the rest is read; throws where that would be in vain. */
  checkHead?: (head: Buffer, size: number) => void
}

/**
 * Reads a file, or the pipe that a shell has opened.
 *
 * @param noun what the file is to the user, e.g. `the face`; put before its path in errors.
 * @throws FurrowError when it cannot be read, or is too large.
 */
export async function readBytes(
  path: string,
  who: string,
  noun = '',
  { most = MAX_FILE_BYTES, checkHead = () => {} }: ReadRules = {},
): Promise<Buffer> {
  const name = `${noun} ${path}`.trim()
  await checkPath(path, name, who)
  let file: FileHandle | undefined
  try {
    file = await open(path)
    const stats = await file.stat({ bigint: true })
    if (!stats.isFile()) return await readPipe(file, name, who, most)
    recordRead(stats)
    const size = Number(stats.size)
    checkFileBytes(size, name, who, most)
    const head = await file.read(Buffer.alloc(HEAD_BYTES), 0, HEAD_BYTES, 0)
    checkHead(head.buffer.subarray(0, head.bytesRead), size)
    return await file.readFile()
  } catch (error) {
    throw error instanceof FurrowError ? error : cannotRead(who, name, error)
  } finally {
    await file?.close()
  }
}

/** Reads a JSON file; see `readBytes`. Throws FurrowError also when it is not JSON, or too deep. */
export async function readJson(path: string, who: string, noun = ''): Promise<unknown> {
  const bytes = await readBytes(path, who, noun, { most: MAX_JSON_BYTES })
  const name = `${noun} ${path}`.trim()
  return parseJson(bytes, name, who)
}

async function checkPath(path: string, name: string, who: string): Promise<void> {
  if (OPEN_FILE.test(path)) return
  const found = await statOf(path).catch(() => undefined)
  const problem = fileProblem(found)
  if (problem) throw cannotRead(who, name, new Error(problem), { remedy: 'name a file' })
  if (found || !/^https?:\/\//i.test(path)) return
  throw cannotRead(who, name, new Error('it is on the network'), { remedy: 'download it, and name the file' })
}

/** A pipe does not tell its size: it is read until it ends, or is too large. */
async function readPipe(file: FileHandle, name: string, who: string, most: number): Promise<Buffer> {
  const chunks: Buffer[] = []
  let length = 0
  for await (const chunk of file.createReadStream({ autoClose: false })) {
    length += chunk.length
    checkFileBytes(length, name, who, most)
    chunks.push(chunk)
  }
  return Buffer.concat(chunks)
}
