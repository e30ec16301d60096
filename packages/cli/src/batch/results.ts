import {
  appendFileSync,
  closeSync,
  fstatSync,
  mkdirSync,
  openSync,
  readFileSync,
  readSync,
  writeSync,
} from 'node:fs'
import { dirname } from 'node:path'
import { cannotRead, cannotWrite } from 'furrow-files'
import type { Outcome } from './jobs/job.ts'

const WHO = 'furrow batch'

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
 * Reads a file of results, as far as it is there: a batch that was ended in the middle of a line has left that line behind.
 *
 * @throws FurrowError where it cannot be read.
 */
export function readResults(path: string): Map<string, ResultLine> {
  let text: string
  try {
    text = readFileSync(path, 'utf8')
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code === 'ENOENT') return new Map()
    throw cannotRead(WHO, path, error)
  }
  const lines = text.split('\n').flatMap((line): ResultLine[] => {
    try {
      return [JSON.parse(line)]
    } catch {
      return []
    }
  })
  return new Map(lines.filter(isResult).map((line) => [lineId(line), line]))
}

function isResult(line: unknown): line is ResultLine {
  return typeof line === 'object' && line !== null && 'input' in line && 'status' in line
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
