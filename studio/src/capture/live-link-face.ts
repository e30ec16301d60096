import { FurrowError } from 'furrow'
import { fillGaps } from './fill-gaps.ts'
import { linesOf } from './lines-of.ts'
import { parseTimecode, secondsSinceFirst, type Timecode } from './timecode.ts'

/** Facial capture: weights of blendshapes over time. */
export interface Capture {
  /** File name without extension. */
  readonly name: string
  /** Times of at least two frames, seconds since the first frame, strictly increasing. */
  readonly times: Float32Array
  /** Weights of each blendshape at `times`, 0..1. The keys are blendshape names as in the file. */
  readonly weights: ReadonlyMap<string, Float32Array>
}

/** Maximum file size in bytes, characters per line, and frames (over half an hour at 60 fps). */
const MAX = { bytes: 128 * 2 ** 20, line: 65_536, frames: 120_000 } as const
const SEPARATORS = [',', ';', '\t'] as const
/** Skipped columns: rotations of the head, which stays still, and of the eyes, whose motion the blendshapes already contain. */
const ROTATION = /^(Head|LeftEye|RightEye)(Yaw|Pitch|Roll)$/i

/**
 * Reads a CSV export of the iOS app Live Link Face: a header (`Timecode,BlendShapeCount,EyeBlinkLeft, ...,HeadYaw, ...`), then one
 * row per frame. Columns can be missing and in any order. Decimal commas are accepted if another character separates columns.
 * Drops a truncated last row, and frames whose time is not later than the time of the frame before. Interpolates the values of blank cells.
 * Also interpolates the time of a frame if its timecode is blank or an integer.
 *
 * Rejects with a FurrowError if the file has another format or contains an invalid number.
 */
export async function readLiveLinkFace(file: File): Promise<Capture> {
  if (file.size > MAX.bytes) {
    throw unusableError(
      file,
      'it is too large',
      `${Math.ceil(file.size / 2 ** 20)} MB`,
      `${MAX.bytes / 2 ** 20} MB`,
    )
  }
  let table: Table | null = null
  for await (const line of linesOf(file, MAX.line)) {
    if (line.length >= MAX.line) throw notLiveLinkError(file)
    if (line.trim() === '') continue
    if (table) table.add(line)
    else table = new Table(file, line)
  }
  if (!table) throw notLiveLinkError(file)
  return table.finish()
}

/** Parser of the CSV, row by row. */
class Table {
  readonly #file: File
  readonly #separator: string
  readonly #names: readonly string[]
  /** Index of the timecode column, or -1. */
  readonly #timecode: number
  /** Columns of blendshapes. Blank cells are NaN. */
  readonly #columns: readonly { name: string; index: number; values: number[] }[]
  readonly #timecodes: (Timecode | null)[] = []
  #rows = 0
  /** Number of the frame whose row has too few cells, or null. Only the last row may have too few cells. */
  #short: number | null = null

  constructor(file: File, header: string) {
    this.#file = file
    const count = (separator: string) => header.split(separator).length
    const [separator] = SEPARATORS.toSorted((a, b) => count(b) - count(a))
    this.#separator = separator
    this.#names = header.split(separator).map(unquote)
    this.#timecode = this.#names.findIndex((name) => /^timecode$/i.test(name))
    const isMetadata = (name: string) => name === '' || /^(timecode|blendshapecount)$/i.test(name)
    if (!this.#names.some((name) => name !== '' && isMetadata(name))) throw notLiveLinkError(file)
    this.#columns = this.#names.flatMap((name, index) =>
      isMetadata(name) || ROTATION.test(name) ? [] : [{ name, index, values: [] }],
    )
    if (this.#columns.length === 0) throw unusableError(file, 'it has no blendshapes')
  }

  /** Adds a row. Throws FurrowError if it is invalid. */
  add(line: string): void {
    this.#rows++
    if (this.#short !== null) throw this.#rowError(this.#short, 'cells are missing')
    if (this.#rows > MAX.frames)
      throw unusableError(this.#file, 'it is too long', undefined, `${MAX.frames} frames`)
    const cells = line.split(this.#separator).map(unquote)
    if (cells.length < this.#names.length) {
      this.#short = this.#rows
      return
    }
    this.#timecodes.push(this.#timecodeOf(cells))
    for (const { name, index, values } of this.#columns) {
      values.push(this.#weightOf(cells[index], name) ?? Number.NaN)
    }
  }

  finish(): Capture {
    const moments = this.#timecodes.length > 0 ? secondsSinceFirst(this.#timecodes) : []
    const kept: number[] = []
    for (const [i, moment] of moments.entries()) {
      if (i === 0 || moment > moments[kept.at(-1)!]) kept.push(i)
    }
    if (kept.length < 2) throw unusableError(this.#file, 'it has no motion', kept.length, '2 frames or more')
    const weights = this.#columns.flatMap(({ name, values }): [string, Float32Array][] => {
      if (values.every(Number.isNaN)) return []
      const filled = fillGaps(values, 0)
      return [[name, Float32Array.from(kept, (i) => filled[i])]]
    })
    return {
      name: this.#file.name.replace(/\.[^.]+$/, ''),
      times: Float32Array.from(kept, (i) => moments[i]),
      weights: new Map(weights),
    }
  }

  /** Returns the timecode of the current row, or null for a blank cell or an integer. Without timecodes, assumes 60 fps. */
  #timecodeOf(cells: readonly string[]): Timecode | null {
    if (this.#timecode < 0)
      return { seconds: Math.floor((this.#rows - 1) / 60), frames: (this.#rows - 1) % 60 }
    const text = cells[this.#timecode]
    if (/^\d*$/.test(text)) return null
    const timecode = parseTimecode(text)
    if (!timecode) throw this.#rowError(this.#rows, 'invalid timecode', text, 'HH:MM:SS:FF')
    return timecode
  }

  /** Returns null for a blank cell. */
  #weightOf(cell: string, name: string): number | null {
    if (cell === '') return null
    const text = this.#separator === ',' ? cell : cell.replace(',', '.')
    const value = Number(text)
    if (!Number.isFinite(value)) throw this.#rowError(this.#rows, name, cell, 'a number')
    return Math.min(Math.max(value, 0), 1)
  }

  #rowError(row: number, problem: string, value?: string, limit?: string): FurrowError {
    return unusableError(this.#file, `frame ${row}, ${problem}`, value?.slice(0, 40), limit)
  }
}

function unquote(cell: string): string {
  return cell.trim().replace(/^"(.*)"$/, '$1')
}

function notLiveLinkError(file: File): FurrowError {
  return unusableError(file, 'its first row has no Timecode', undefined, 'a CSV of Live Link Face')
}

function unusableError(file: File, problem: string, value?: unknown, limit?: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who: 'Studio',
    problem: `${file.name} cannot be played: ${problem}`,
    value,
    limit,
    remedy: 'export the take from Live Link Face again, as CSV',
  })
}
