import { FurrowError } from '../core/error.ts'
import type { Face } from './face.ts'

/** The rectangle of the atlas that holds the influence map of one face. */
export interface Cell {
  readonly face: Face
  /** Row by row. */
  readonly index: number
  /** The activations that were drawn last, by area; NaN if none were. */
  readonly drawn: Float32Array
  /** Version of the areas that were drawn last; `STALE` if it must be drawn: the face has other areas, or the texture is new. */
  version: number
  /** Version of the activations that were last found to be as drawn. */
  unchanged: number
}

/** No version that areas have. */
export const STALE = -1

/** Half a step of 8 bits: a smaller change of an activation is invisible. */
const SMALLEST_CHANGE = 1 / 510

/** In texels. All WebGL 2 and WebGPU devices in use support textures of this size. */
const LARGEST_SIDE = 8192

/** Four numbers, as vectors of engines have them. */
export interface Four {
  x: number
  y: number
  z: number
  w: number
}

/** The layout of an atlas of influence maps: a grid of cells of one size, and which of them must be redrawn. */
export class AtlasCells {
  /** Size of a cell in texels, that of the faces' areas. */
  readonly width: number
  readonly height: number
  /**
   * Factors and offsets (x, y and z, w) that take texture coordinates to 0 at the centre of a cell's first texel, and to 1 at that of its last. Shaders
   * clamp the result, so that samples do not reach the neighbours: a limit to 0..1 is part of a multiplication on graphics cards, another is not.
   */
  readonly inside: Readonly<Four>
  /** Columns and rows of cells. */
  readonly grid = { columns: 1, rows: 1 }
  /** The cells to redraw are the first `changes` of these: emptying the list would allocate. */
  readonly changed: Cell[] = []
  changes = 0
  readonly #cells: (Cell | null)[] = []
  #used = 0

  constructor(width: number, height: number) {
    this.width = width
    this.height = height
    // A cell of one texel is the same everywhere.
    const [across, down] = [width - 1 || 1, height - 1 || 1]
    this.inside = { x: width / across, y: height / down, z: -0.5 / across, w: -0.5 / down }
  }

  get isEmpty(): boolean {
    return this.#used === 0
  }

  /** Whether there is one cell, which is all of the atlas: shaders then sample it at texture coordinates as they are. */
  get isSingle(): boolean {
    return this.grid.columns * this.grid.rows === 1
  }

  /** Whether all cells that are used are to be redrawn. */
  get isWhole(): boolean {
    return this.changes === this.#used
  }

  /** The arrays of areas that the faces use. */
  get slots(): Set<Face['slots']> {
    return new Set(this.#cells.flatMap((cell) => (cell ? [cell.face.slots] : [])))
  }

  /**
   * Allocates consecutive cells to faces. The grid may grow, and then all cells are stale.
   *
   * @throws FurrowError when they do not fit into the largest texture.
   */
  add(faces: readonly Face[]): Cell[] {
    const first = this.#findFree(faces.length)
    this.#grow(first + faces.length)
    this.#used += faces.length
    return faces.map((face, i) => {
      const drawn = new Float32Array(face.activations.values.length).fill(Number.NaN)
      const cell: Cell = { face, index: first + i, drawn, version: STALE, unchanged: -1 }
      this.#cells[first + i] = cell
      return cell
    })
  }

  /** Frees cells. */
  remove(cells: readonly Cell[]): void {
    for (const { index } of cells) this.#cells[index] = null
    this.#used -= cells.length
    this.changed.length = 0
    this.changes = 0
    while (this.#cells.length > 0 && this.#cells[this.#cells.length - 1] === null) this.#cells.pop()
  }

  /** Adds to `changed` those of some cells that must be redrawn. */
  collect(cells: readonly Cell[]): void {
    for (let i = 0; i < cells.length; i++) if (hasChanged(cells[i])) this.changed[this.changes++] = cells[i]
  }

  /** Finds the centre of a cell's first texel (x, y), and how far that of its last is (z, w), in 0..1 of the atlas. */
  locate(index: number, place: Four): void {
    const { width, height } = this
    const { columns, rows } = this.grid
    place.x = ((index % columns) + 0.5 / width) / columns
    place.y = (Math.floor(index / columns) + 0.5 / height) / rows
    place.z = (1 - 1 / width) / columns
    place.w = (1 - 1 / height) / rows
  }

  /** Marks all cells stale: what was drawn is lost. */
  invalidate(): void {
    for (const cell of this.#cells) if (cell) cell.version = STALE
  }

  /** Index of the first of `count` consecutive free cells. */
  #findFree(count: number): number {
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
        problem: 'too many faces with influence maps of this size',
        value: `${count} of ${this.width} x ${this.height} texels`,
        limit: `one texture of ${LARGEST_SIDE} x ${LARGEST_SIDE} for all`,
        remedy: 'give the faces of a crowd smaller areas (areaSize)',
      })
    }
    Object.assign(this.grid, { columns, rows })
    this.invalidate()
  }
}

function hasChanged(cell: Cell): boolean {
  const { face, drawn, version } = cell
  if (version !== face.slots.version) return true
  const { activations } = face
  if (cell.unchanged === activations.version) return false
  const { values } = activations
  const count = face.slots.slots.length
  for (let i = 0; i < count; i++) if (hasMoved(values[i], drawn[i])) return true
  cell.unchanged = activations.version
  return false
}

/**
 * Whether an activation has changed enough to be redrawn. Any change from or to 0 counts: at 0, skin must be smooth to the
 * last bit.
 */
export function hasMoved(value: number, drawn: number): boolean {
  const change = Math.abs(value - drawn)
  return change > SMALLEST_CHANGE || (change > 0 && (value === 0 || drawn === 0))
}
