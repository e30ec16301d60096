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
import { LONGEST, parseOutcome } from './jobs/records.ts'

const WHO = 'furrow batch'

/** A result may hold all that `furrow validate` found. */
const MOST_LINE_BYTES = MAX_JSON_BYTES

/** A line of the results: what came of an input. */
export interface ResultLine extends Outcome {
  /** Of its job; absent where the input could not be read. */
  key?: string
  command: string
  input: string
  output?: string
  /** The input whose job this one shares, being the same bytes with the same options. */
  sameAs?: string
}

/** The line of a job in a file of results: the last one counts. */
export function lineId({ key, input, output }: Pick<ResultLine, 'key' | 'input' | 'output'>): string {
  return JSON.stringify([key, output ?? input])
}

/**
 * Reads a file of results, as far as it is there: a batch that was ended in the middle of a line has left that line behind. Lines that are
 * no results are ignored, with one warning for all.
 *
 * @throws FurrowError where it cannot be read.
 */
export function readResults(path: string): Map<string, ResultLine> {
  const results = new Map<string, ResultLine>()
  const faults: string[] = []
  let number = 0
  for (const text of linesOf(path)) {
    number++
    try {
      const line = parseLine(text)
      if (line) results.set(lineId(line), line)
    } catch (error) {
      faults.push(`line ${number}: ${firstLine(error)}`)
    }
  }
  if (faults.length > 0) {
    const count = faults.length === 1 ? 'a line' : `${faults.length} lines`
    warn(`${WHO}: ${path} has ${count} that cannot be used; the first is ${faults[0]}`)
  }
  return results
}

/** The result in a line; undefined for one that was cut off. Throws FurrowError for what is no result. */
function parseLine(text: string): ResultLine | undefined {
  let json: unknown
  try {
    json = JSON.parse(text)
  } catch {
    return undefined
  }
  return parseResult(json)
}

/** Reads a result; see `parseOutcome`. */
function parseResult(json: unknown): ResultLine {
  const reader = new JsonReader('a result')
  const { key, command, input, output, sameAs } = reader.object(json, 'a result')
  const text = (value: unknown, path: string) => reader.text(value, path, LONGEST)
  return {
    ...(key !== undefined && { key: text(key, 'key') }),
    command: text(command, 'command'),
    input: text(input, 'input'),
    ...(output !== undefined && { output: text(output, 'output') }),
    ...parseOutcome(json, 'a result'),
    ...(sameAs !== undefined && { sameAs: text(sameAs, 'sameAs') }),
  }
}

/** The lines of a file, without those that are too long; none where there is no file. */
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
        if (length <= MOST_LINE_BYTES) parts.push(Buffer.from(piece, 'latin1'))
        // The last piece goes on in the next chunk.
        if (i === pieces.length - 1 && count > 0) break
        if (length <= MOST_LINE_BYTES) yield Buffer.concat(parts).toString()
        ;[parts, length] = [[], 0]
      }
      if (count === 0) return
    }
  } finally {
    closeSync(file)
  }
}

/** A pipe would be waited for. */
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

/** Opens a file of results to add lines. Each is written at once: what it says is done then stays done. */
export function openResults(path: string): { add(line: ResultLine): void; close(): void } {
  return withWriteErrors(path, () => {
    mkdirSync(dirname(path), { recursive: true })
    const file = openSync(path, 'a+')
    const { size } = fstatSync(file)
    const last = Buffer.alloc(1)
    if (size > 0) readSync(file, last, 0, 1, size - 1)
    // The end of a line that was cut off.
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
