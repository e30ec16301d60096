import { FurrowError } from 'furrow'
import { fillGaps } from './fill-gaps.ts'
import { linesOf } from './lines-of.ts'
import { parseTimecode, secondsSinceFirst, type Timecode } from './timecode.ts'

/** A face's blendshapes over time, as a camera has captured them. */
export interface Capture {
  /** Of its file, without the extension. */
  readonly name: string
  /** Seconds since the first frame, increasing; at least two. */
  readonly times: Float32Array
  /** Weights, 0..1, one per time, by the names of blendshapes in the file. */
  readonly weights: ReadonlyMap<string, Float32Array>
}

/** Largest file in bytes, most characters of a line, and most frames: over half an hour at 60 per second. */
const MOST = { bytes: 128 * 2 ** 20, line: 65_536, frames: 120_000 } as const
const SEPARATORS = [',', ';', '\t'] as const
/** Columns that are not blendshapes: the head's and the eyes' rotations. The app gives the eyes' gaze as blendshapes as well. */
const ROTATION = /^(Head|LeftEye|RightEye)(Yaw|Pitch|Roll)$/i

/**
 * Reads what the iOS app Live Link Face exports: a row of names (`Timecode,BlendShapeCount,EyeBlinkLeft, ...,HeadYaw, ...`), then a row of
 * numbers per frame. Columns may be missing and in any order; numbers may have a decimal comma where it does not separate columns. A frame
 * that is not later than the one before it is left out, and so is a last row that is cut off. A blank cell, and a timecode that is a whole
 * number, is skipped: its value lies between those before and after it.
 *
 * Rejects with a FurrowError when it is no such file, or a number in it cannot be used.
 */
export async function readLiveLinkFace(file: File): Promise<Capture> {
  if (file.size > MOST.bytes) {
    throw unusable(
      file,
      'it is too large',
      `${Math.ceil(file.size / 2 ** 20)} MB`,
      `${MOST.bytes / 2 ** 20} MB`,
    )
  }
  let table: Table | null = null
  for await (const line of linesOf(file, MOST.line)) {
    if (line.length >= MOST.line) throw notLiveLink(file)
    if (line.trim() === '') continue
    if (table) table.add(line)
    else table = new Table(file, line)
  }
  if (!table) throw notLiveLink(file)
  return table.finish()
}

/** The rows as they are read. */
class Table {
  readonly #file: File
  readonly #separator: string
  readonly #names: readonly string[]
  /** Index of the column of timecodes; -1 where there is none. */
  readonly #timecode: number
  /** A value is NaN where its cell is blank. */
  readonly #columns: readonly { name: string; index: number; values: number[] }[]
  readonly #timecodes: (Timecode | null)[] = []
  #rows = 0
  /** The last row where cells are missing from it. */
  #short: number | null = null

  constructor(file: File, header: string) {
    this.#file = file
    const count = (separator: string) => header.split(separator).length
    const [separator] = SEPARATORS.toSorted((a, b) => count(b) - count(a))
    this.#separator = separator
    this.#names = header.split(separator).map(plain)
    this.#timecode = this.#names.findIndex((name) => /^timecode$/i.test(name))
    const isOther = (name: string) => name === '' || /^(timecode|blendshapecount)$/i.test(name)
    if (!this.#names.some((name) => name !== '' && isOther(name))) throw notLiveLink(file)
    this.#columns = this.#names.flatMap((name, index) =>
      isOther(name) || ROTATION.test(name) ? [] : [{ name, index, values: [] }],
    )
    if (this.#columns.length === 0) throw unusable(file, 'it has no blendshapes')
  }

  /** Adds a row. Throws FurrowError when it cannot be used. */
  add(line: string): void {
    this.#rows++
    if (this.#short !== null) throw this.#wrong(this.#short, 'cells are missing')
    if (this.#rows > MOST.frames)
      throw unusable(this.#file, 'it is too long', undefined, `${MOST.frames} frames`)
    const cells = line.split(this.#separator).map(plain)
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
    if (kept.length < 2) throw unusable(this.#file, 'it has no motion', kept.length, '2 frames or more')
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

  /** Without timecodes, frames are as far apart as the app takes them. Null for a cell that is blank or a whole number. */
  #timecodeOf(cells: readonly string[]): Timecode | null {
    if (this.#timecode < 0)
      return { seconds: Math.floor((this.#rows - 1) / 60), frames: (this.#rows - 1) % 60 }
    const text = cells[this.#timecode]
    if (/^\d*$/.test(text)) return null
    const timecode = parseTimecode(text)
    if (!timecode) throw this.#wrong(this.#rows, 'its timecode', text, 'HH:MM:SS:FF')
    return timecode
  }

  /** Null for a cell that is blank. */
  #weightOf(cell: string, name: string): number | null {
    if (cell === '') return null
    const text = this.#separator === ',' ? cell : cell.replace(',', '.')
    const value = Number(text)
    if (!Number.isFinite(value)) throw this.#wrong(this.#rows, name, cell, 'a number')
    return Math.min(Math.max(value, 0), 1)
  }

  #wrong(row: number, what: string, value?: string, limit?: string): FurrowError {
    return unusable(this.#file, `frame ${row}, ${what}`, value?.slice(0, 40), limit)
  }
}

/** A cell without what programs put round it. */
function plain(cell: string): string {
  return cell.trim().replace(/^"(.*)"$/, '$1')
}

function notLiveLink(file: File): FurrowError {
  return unusable(file, 'its first row has no Timecode', undefined, 'a CSV of Live Link Face')
}

function unusable(file: File, what: string, value?: unknown, limit?: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who: 'Studio',
    problem: `${file.name} cannot be played: ${what}`,
    value,
    limit,
    remedy: 'export the take from Live Link Face again, as CSV',
  })
}
