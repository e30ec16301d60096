import { type FileHandle, open } from 'node:fs/promises'
import { FurrowError } from 'furrow'
import { cannotRead } from '../base/errors.ts'
import { HEAD_BYTES } from '../base/file-kind.ts'
import { checkFileBytes, MAX_FILE_BYTES, MAX_JSON_BYTES } from '../base/file-size.ts'
import { parseJson } from '../base/json-file.ts'
import { fileProblem, statOf } from './file-status.ts'
import { recordRead } from './files-read.ts'

/**
 * Paths of files that the shell opens, as in `furrow inspect <(...)`. All other paths must be regular files: a pipe may
 * have no writer, and a device may never end.
 */
const OPEN_FILE = /^\/(dev\/stdin|(dev|proc\/self)\/fd\/\d+)$/

/** Limits for reading a file. */
export interface ReadRules {
  /** Maximum size, bytes. */
  maxBytes?: number
  /** Called with the first bytes and the size of a file before the rest is read. Throws to reject the file. */
  checkHead?: (head: Buffer, size: number) => void
}

/**
 * Reads a file, or a pipe that a shell opened.
 *
 * @param noun words before the path in errors, e.g. `the face`.
 * @throws FurrowError if the file cannot be read, or is too large.
 */
export async function readBytes(
  path: string,
  who: string,
  noun = '',
  { maxBytes = MAX_FILE_BYTES, checkHead = () => {} }: ReadRules = {},
): Promise<Buffer> {
  const name = `${noun} ${path}`.trim()
  await checkPath(path, name, who)
  let file: FileHandle | undefined
  try {
    file = await open(path)
    const stats = await file.stat({ bigint: true })
    if (!stats.isFile()) return await readPipe(file, name, who, maxBytes)
    recordRead(stats)
    const size = Number(stats.size)
    checkFileBytes(size, name, who, maxBytes)
    const head = await file.read(Buffer.alloc(HEAD_BYTES), 0, HEAD_BYTES, 0)
    checkHead(head.buffer.subarray(0, head.bytesRead), size)
    return await file.readFile()
  } catch (error) {
    throw error instanceof FurrowError ? error : cannotRead(who, name, error)
  } finally {
    await file?.close()
  }
}

/** Reads and parses a JSON file. Throws like `readBytes`, and if the file is not JSON or is nested too deeply. */
export async function readJson(path: string, who: string, noun = ''): Promise<unknown> {
  const bytes = await readBytes(path, who, noun, { maxBytes: MAX_JSON_BYTES })
  const name = `${noun} ${path}`.trim()
  return parseJson(bytes, name, who)
}

async function checkPath(path: string, name: string, who: string): Promise<void> {
  if (OPEN_FILE.test(path)) return
  const found = await statOf(path).catch(() => undefined)
  const problem = fileProblem(found)
  if (problem) throw cannotRead(who, name, new Error(problem), { remedy: 'choose a file' })
  if (found || !/^https?:\/\//i.test(path)) return
  throw cannotRead(who, name, new Error('it is a URL'), { remedy: 'download the file' })
}

/** Reads a pipe to its end. Throws as soon as the data exceeds `maxBytes`. */
async function readPipe(file: FileHandle, name: string, who: string, maxBytes: number): Promise<Buffer> {
  const chunks: Buffer[] = []
  let length = 0
  for await (const chunk of file.createReadStream({ autoClose: false })) {
    length += chunk.length
    checkFileBytes(length, name, who, maxBytes)
    chunks.push(chunk)
  }
  return Buffer.concat(chunks)
}
