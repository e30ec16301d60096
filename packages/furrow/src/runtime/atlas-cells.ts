import { FurrowError } from '../core/error.ts'
import type { Face } from './face.ts'

/** A face's part of the atlas, and what is drawn there. */
export interface Cell {
  readonly face: Face
  readonly index: number
  /** The activations drawn last, by area; NaN where nothing is drawn yet. */
  readonly drawn: Float32Array
  /** Whether it must be drawn whatever its activations: its areas changed, or the texture is new. */
  stale: boolean
}

/** A smaller change of an activation changes no byte of the influence. */
const SMALLEST_CHANGE = 1 / 510

/** Every WebGL 2 and WebGPU device in use supports textures of this size. */
const LARGEST_SIDE = 8192

/** The layout of an atlas of influence maps: cells of one size in columns and rows, and which of them must be drawn again. */
export class AtlasCells {
  /** Size of a cell in texels: that of the faces' areas. */
  readonly width: number
  readonly height: number
  /** Columns and rows of cells. */
  readonly grid = { columns: 1, rows: 1 }
  /** Those to be drawn, of which the first `changes`: emptying the list would allocate. */
  readonly changed: Cell[] = []
  changes = 0
  readonly #cells: (Cell | null)[] = []

  constructor(width: number, height: number) {
    this.width = width
    this.height = height
  }

  get isEmpty(): boolean {
    return this.#cells.every((cell) => cell === null)
  }

  /** The arrays of areas that its faces have. */
  get slots(): Set<Face['slots']> {
    return new Set(this.#cells.flatMap((cell) => (cell ? [cell.face.slots] : [])))
  }

  /**
   * Gives faces consecutive cells. The grid may grow: compare its size before and after.
   *
   * @throws FurrowError where they do not fit into the largest texture.
   */
  add(faces: readonly Face[]): Cell[] {
    const first = this.#findRoom(faces.length)
    this.#grow(first + faces.length)
    return faces.map((face, i) => {
      const drawn = new Float32Array(face.activations.values.length).fill(Number.NaN)
      const cell: Cell = { face, index: first + i, drawn, stale: true }
      this.#cells[first + i] = cell
      return cell
    })
  }

  remove(cells: readonly Cell[]): void {
    for (const { index } of cells) this.#cells[index] = null
    this.changed.length = 0
    this.changes = 0
    while (this.#cells.length > 0 && this.#cells[this.#cells.length - 1] === null) this.#cells.pop()
  }

  /** Adds those among some cells whose activations have changed since they were drawn. */
  collect(cells: readonly Cell[]): void {
    for (let i = 0; i < cells.length; i++) if (hasChanged(cells[i])) this.changed[this.changes++] = cells[i]
  }

  /** Has all cells drawn again: their texture is gone. */
  invalidate(): void {
    for (const cell of this.#cells) if (cell) cell.stale = true
  }

  /** Index of the first of as many free cells in a row. */
  #findRoom(count: number): number {
    let run = 0
    for (let i = 0; i < this.#cells.length; i++) {
      run = this.#cells[i] === null ? run + 1 : 0
      if (run === count) return i + 1 - count
    }
    return this.#cells.length - run
  }

  #grow(count: number): void {
    let { columns, rows } = this.grid
    while (columns * rows < count) {
      if (columns * this.width <= rows * this.height) columns *= 2
      else rows *= 2
    }
    if (columns === this.grid.columns && rows === this.grid.rows) return
    if (Math.max(columns * this.width, rows * this.height) > LARGEST_SIDE) {
      throw new FurrowError({
        code: 'out-of-range',
        who: 'Wrinkles',
        what: 'too many faces with influence maps of this size',
        value: `${count} of ${this.width} x ${this.height} texels`,
        limit: `one texture of ${LARGEST_SIDE} x ${LARGEST_SIDE} for all`,
        remedy: 'give the faces of a crowd smaller areas (areaSize)',
      })
    }
    Object.assign(this.grid, { columns, rows })
    this.invalidate()
  }
}

function hasChanged({ face, drawn, stale }: Cell): boolean {
  if (stale) return true
  const { values } = face.activations
  const count = face.slots.slots.length
  for (let i = 0; i < count; i++) if (hasMoved(values[i], drawn[i])) return true
  return false
}

/**
 * Whether an activation must be drawn again. One that starts or ends at 0 counts however little it moved: where it is 0, skin is
 * smooth to the last bit.
 */
export function hasMoved(value: number, drawn: number): boolean {
  const change = Math.abs(value - drawn)
  return change > SMALLEST_CHANGE || (change > 0 && (value === 0 || drawn === 0))
}
