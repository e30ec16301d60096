import { FurrowError } from '../core/error.ts'
import type { Face } from './face.ts'

/** Rectangle of the atlas texture that stores the influence map of one face. */
export interface Cell {
  readonly face: Face
  /** Index in the grid of cells, counted row by row. */
  readonly index: number
  /** Activation of each area when the cell was last drawn; NaN before the first draw. */
  readonly drawn: Float32Array
  /** Version of the areas' weights when the cell was last drawn, or `STALE` if the cell must be redrawn. */
  version: number
  /** Version of the activations at the last comparison with `drawn` that found no visible difference. */
  drawnVersion: number
}

/** Value of `Cell.version` that forces a redraw. Weights never have this version. */
export const STALE = -1

/** Smallest visible change of an activation: half an 8-bit step. */
const SMALLEST_CHANGE = 1 / 510

/** Maximum width and height of the atlas in texels, supported by all WebGL 2 and WebGPU devices in use. */
const MAX_SIDE = 8192

/** Vector that is compatible with the vector classes of engines. */
export interface Vector4Like {
  x: number
  y: number
  z: number
  w: number
}

/**
 * Layout of a texture atlas with the influence maps of many faces. An influence map stores how visible each wrinkle layer is at each point of
 * the skin. The atlas is a grid of cells, one per face.
 */
export class AtlasCells {
  /** Width of a cell in texels, equal to the width of the weight maps of areas. All faces in the atlas have weight maps of one size. */
  readonly width: number
  /** Height of a cell in texels, equal to the height of the weight maps. */
  readonly height: number
  /**
   * Factors (x, y) and offsets (z, w) for texture coordinates. They map the centre of a cell's first texel to 0 and the centre of its last
   * texel to 1. Shaders clamp the mapped coordinates to 0..1, so that samples do not reach neighbouring cells. Clamping to 0..1 costs
   * nothing on GPUs.
   */
  readonly inside: Readonly<Vector4Like>
  readonly grid = { columns: 1, rows: 1 }
  /** The first `changes` items are the cells to redraw. The array is not emptied after a frame, because filling it again would allocate. */
  readonly changed: Cell[] = []
  changes = 0
  readonly #cells: (Cell | null)[] = []
  #used = 0

  constructor(width: number, height: number) {
    this.width = width
    this.height = height
    // If a cell is one texel wide or high, the divisor is 1 instead of 0.
    const [across, down] = [width - 1 || 1, height - 1 || 1]
    this.inside = { x: width / across, y: height / down, z: -0.5 / across, w: -0.5 / down }
  }

  get isEmpty(): boolean {
    return this.#used === 0
  }

  /** Whether a single cell fills the atlas. Shaders then use texture coordinates unchanged. */
  get isSingle(): boolean {
    return this.grid.columns * this.grid.rows === 1
  }

  /** Whether all cells in use must be redrawn. */
  get allChanged(): boolean {
    return this.changes === this.#used
  }

  /** For each wrinkle set that the faces use, the slices and channels of the texture array that store the weights of its areas. */
  get slots(): Set<Face['slots']> {
    return new Set(this.#cells.flatMap((cell) => (cell ? [cell.face.slots] : [])))
  }

  /**
   * Allocates consecutive cells for faces. If the grid must grow, all cells are marked `STALE`.
   *
   * @throws FurrowError if the cells do not fit into the largest texture.
   */
  add(faces: readonly Face[]): Cell[] {
    const first = this.#findFree(faces.length)
    this.#grow(first + faces.length)
    this.#used += faces.length
    return faces.map((face, i) => {
      const drawn = new Float32Array(face.activations.values.length).fill(Number.NaN)
      const cell: Cell = { face, index: first + i, drawn, version: STALE, drawnVersion: -1 }
      this.#cells[first + i] = cell
      return cell
    })
  }

  remove(cells: readonly Cell[]): void {
    for (const { index } of cells) this.#cells[index] = null
    this.#used -= cells.length
    this.changed.length = 0
    this.changes = 0
    while (this.#cells.length > 0 && this.#cells[this.#cells.length - 1] === null) this.#cells.pop()
  }

  /** Appends to `changed` the cells that must be redrawn. */
  collect(cells: readonly Cell[]): void {
    for (let i = 0; i < cells.length; i++) if (hasChanged(cells[i])) this.changed[this.changes++] = cells[i]
  }

  /**
   * Computes the position of a cell in texture coordinates of the atlas.
   *
   * @param place receives the centre of the cell's first texel (x, y), and the offset from there to the centre of its last texel (z, w).
   */
  locate(index: number, place: Vector4Like): void {
    const { width, height } = this
    const { columns, rows } = this.grid
    place.x = ((index % columns) + 0.5 / width) / columns
    place.y = (Math.floor(index / columns) + 0.5 / height) / rows
    place.z = (1 - 1 / width) / columns
    place.w = (1 - 1 / height) / rows
  }

  /** Marks all cells `STALE`. Call when the content of the atlas texture is lost. */
  invalidate(): void {
    for (const cell of this.#cells) if (cell) cell.version = STALE
  }

  /** Returns the index of the first of `count` consecutive free cells. */
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
    if (Math.max(columns * this.width, rows * this.height) > MAX_SIDE) {
      throw new FurrowError({
        code: 'out-of-range',
        who: 'Wrinkles',
        problem: 'too many faces for one influence texture',
        value: `${count} faces of ${this.width} x ${this.height} texels`,
        limit: `a texture of ${MAX_SIDE} x ${MAX_SIDE} texels for all faces`,
        remedy: 'use a smaller areaSize for the faces of a crowd',
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
  if (cell.drawnVersion === activations.version) return false
  const { values } = activations
  const count = face.slots.slots.length
  for (let i = 0; i < count; i++) if (hasMoved(values[i], drawn[i])) return true
  cell.drawnVersion = activations.version
  return false
}

/** Whether an activation has changed visibly. Any change from or to 0 counts, because skin must be exactly smooth at 0. */
export function hasMoved(value: number, drawn: number): boolean {
  const change = Math.abs(value - drawn)
  return change > SMALLEST_CHANGE || (change > 0 && (value === 0 || drawn === 0))
}
