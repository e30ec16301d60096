import {
  appendFileSync,
  closeSync,
  fstatSync,
  mkdirSync,
  openSync,
  readSync,
  statSync,
  writeSync,
} from 'node:fs'
import { dirname } from 'node:path'
import { JsonReader } from 'furrow/internal'
import { cannotRead, cannotWrite, firstLine, MAX_JSON_BYTES } from 'furrow-files'
import { fileProblem } from 'furrow-files/node'
import { warn } from '../print.ts'
import type { Outcome } from './jobs/job.ts'
import { MAX_TEXT_LENGTH, parseOutcome } from './jobs/records.ts'

const WHO = 'furrow batch'

/** Maximum length of a line, bytes. A line can contain all findings of `furrow validate`. */
const MAX_LINE_BYTES = MAX_JSON_BYTES

/** Line of the results file: the result of one input. */
export interface ResultLine extends Outcome {
  /** Key of the job. Absent if the input could not be read. */
  key?: string
  command: string
  input: string
  output?: string
  /** Another input with the same content, whose job produced this result. */
  sameAs?: string
}

/** Returns the id of a result. If several lines of a file have the same id, the last line is valid. */
export function lineId({ key, input, output }: Pick<ResultLine, 'key' | 'input' | 'output'>): string {
  return JSON.stringify([key, output ?? input])
}

/**
 * Reads the results file of an earlier run, if it exists. Skips incomplete lines, which an interrupted batch leaves.
 * Skips invalid lines with one warning.
 *
 * @throws FurrowError if the file cannot be read.
 */
export function readResults(path: string): Map<string, ResultLine> {
  const results = new Map<string, ResultLine>()
  const errors: string[] = []
  let number = 0
  for (const text of linesOf(path)) {
    number++
    try {
      const line = parseLine(text)
      if (line) results.set(lineId(line), line)
    } catch (error) {
      errors.push(`line ${number}: ${firstLine(error)}`)
    }
  }
  if (errors.length > 0) {
    const count = errors.length === 1 ? '1 invalid line' : `${errors.length} invalid lines`
    warn(`${WHO}: ignored ${count} in ${path}, first in ${errors[0]}`)
  }
  return results
}

/** Parses a line. Returns undefined if it is incomplete. Throws if it is JSON but not a result. */
function parseLine(text: string): ResultLine | undefined {
  let json: unknown
  try {
    json = JSON.parse(text)
  } catch {
    return undefined
  }
  return parseResult(json)
}

function parseResult(json: unknown): ResultLine {
  const reader = new JsonReader('a result')
  const { key, command, input, output, sameAs } = reader.object(json, 'a result')
  const text = (value: unknown, path: string) => reader.text(value, path, MAX_TEXT_LENGTH)
  return {
    ...(key !== undefined && { key: text(key, 'key') }),
    command: text(command, 'command'),
    input: text(input, 'input'),
    ...(output !== undefined && { output: text(output, 'output') }),
    ...parseOutcome(json, 'a result'),
    ...(sameAs !== undefined && { sameAs: text(sameAs, 'sameAs') }),
  }
}

/** Yields the lines of a file, except lines that are too long. Yields nothing if the file does not exist. */
function* linesOf(path: string): Generator<string> {
  const file = withReadErrors(path, () => openRegular(path))
  if (file === undefined) return
  try {
    const chunk = Buffer.alloc(2 ** 16)
    let [parts, length]: [Buffer[], number] = [[], 0]
    for (;;) {
      const count = withReadErrors(path, () => readSync(file, chunk))
      const pieces = chunk.toString('latin1', 0, count).split('\n')
      for (const [i, piece] of pieces.entries()) {
        length += piece.length
        if (length <= MAX_LINE_BYTES) parts.push(Buffer.from(piece, 'latin1'))
        // The last part of a chunk continues in the next chunk.
        if (i === pieces.length - 1 && count > 0) break
        if (length <= MAX_LINE_BYTES) yield Buffer.concat(parts).toString()
        ;[parts, length] = [[], 0]
      }
      if (count === 0) return
    }
  } finally {
    closeSync(file)
  }
}

/** Opens a file, if it exists. Throws if it is not a regular file, because opening a pipe would block. */
function openRegular(path: string): number | undefined {
  const found = statSync(path, { throwIfNoEntry: false })
  if (!found) return undefined
  const problem = fileProblem(found)
  if (problem) throw new Error(problem)
  return openSync(path, 'r')
}

function withReadErrors<T>(path: string, read: () => T): T {
  try {
    return read()
  } catch (error) {
    throw cannotRead(WHO, path, error)
  }
}

/** Opens a results file to append lines. Each line is written immediately, so that an interruption loses no results. */
export function openResults(path: string): { add(line: ResultLine): void; close(): void } {
  return withWriteErrors(path, () => {
    mkdirSync(dirname(path), { recursive: true })
    const file = openSync(path, 'a+')
    const { size } = fstatSync(file)
    const last = Buffer.alloc(1)
    if (size > 0) readSync(file, last, 0, 1, size - 1)
    // Ends the incomplete line that an interrupted batch left.
    if (size > 0 && last.toString() !== '\n') writeSync(file, '\n')
    const add = (line: ResultLine) => appendFileSync(file, `${JSON.stringify(line)}\n`)
    return {
      add: (line) => withWriteErrors(path, () => add(line)),
      close: () => closeSync(file),
    }
  })
}

function withWriteErrors<T>(path: string, write: () => T): T {
  try {
    return write()
  } catch (error) {
    throw cannotWrite(WHO, path, error)
  }
}
