import type { WebGLRenderer } from 'three'
import { HalfFloatType, LinearFilter, RedFormat, RenderTarget, RGBAFormat, RGFormat } from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import { FurrowError } from '../../core/error.ts'
import type { AreaArray } from './area-array.ts'
import { InfluencePass, type QuadMaterials } from './influence-pass.ts'

export type AnyRenderer = WebGLRenderer | WebGPURenderer

/** A face of the atlas: one mesh, or one instance of it. */
export interface AtlasFace {
  /** Its areas, and their activations in the same order. */
  readonly areas: AreaArray
  readonly values: Float32Array
  /** Brings `values` up to date with whatever drives them. */
  drive(renderer: AnyRenderer): void
}

/** A face's place, and what stands there. */
export interface Cell {
  readonly face: AtlasFace
  readonly index: number
  /** The activations drawn last, by area; NaN where nothing is drawn yet. */
  readonly drawn: Float32Array
  /** Whether the areas themselves changed. */
  stale: boolean
  /** The frame in which it was brought up to date, and that in which it was seen. */
  updated: number
  seen: number
}

/** An activation that moved by less changes no byte of the influence. */
const LEAST_CHANGE = 1 / 510

/** Every WebGL 2 and WebGPU device in use has textures of this size. */
const LARGEST_SIDE = 8192

const FORMATS = [RedFormat, RGFormat, RGBAFormat, RGBAFormat] as const

/**
 * The influence maps of all faces of one kind, side by side in one texture: per layer, the sum of a face's areas
 * times their activations, in UV space at the areas' resolution. A cell is drawn anew only when an activation of
 * its face moved, and then only over the rectangles of areas that are active; the cells of all faces are drawn at
 * once. Faces' shaders take one sample of it, however many areas there are.
 *
 * Texels hold T = max(sum, largest `max`) unclamped, in half floats; shaders take min(1, T) after
 * interpolation, so that a sum is cut off exactly where the reference cuts it.
 */
export class InfluenceAtlas {
  readonly width: number
  readonly height: number
  readonly layers: number
  readonly target: RenderTarget
  /** Columns and rows of cells. */
  readonly grid = { columns: 1, rows: 1 }

  readonly #pass: InfluencePass
  readonly #cells: (Cell | null)[] = []
  /** Those to be drawn, and how many they are: a list that is emptied would allocate anew each time it is filled. */
  readonly #changed: Cell[] = []
  #changes = 0
  #renderer: AnyRenderer | null = null
  #frame = 0
  /** How often the renderer had been told to render when the atlas was last brought up to date. */
  #renders = -1

  /**
   * @param width, height of a cell: those of the faces' areas.
   * @param layers of the faces, one channel each.
   */
  constructor(width: number, height: number, layers: number, materials: QuadMaterials) {
    this.width = width
    this.height = height
    this.layers = layers
    this.target = new RenderTarget(width, height, {
      format: FORMATS[layers - 1],
      type: HalfFloatType,
      minFilter: LinearFilter,
      magFilter: LinearFilter,
      depthBuffer: false,
    })
    this.#pass = new InfluencePass(this, materials)
  }

  get isEmpty(): boolean {
    return this.#cells.every((cell) => cell === null)
  }

  /**
   * Gives faces cells that follow each other.
   *
   * @throws FurrowError where they do not fit into the largest texture.
   */
  add(faces: readonly AtlasFace[]): Cell[] {
    const first = this.#room(faces.length)
    this.#grow(first + faces.length)
    return faces.map((face, i) => {
      const cell: Cell = {
        face,
        index: first + i,
        drawn: new Float32Array(face.values.length).fill(Number.NaN),
        stale: true,
        updated: -1,
        seen: -1,
      }
      this.#cells[first + i] = cell
      return cell
    })
  }

  remove(cells: readonly Cell[]): void {
    for (const { index } of cells) this.#cells[index] = null
    this.#changed.length = 0
    while (this.#cells.length > 0 && this.#cells[this.#cells.length - 1] === null) this.#cells.pop()
    this.prune()
  }

  /** Frees what was held for areas that no face has any more. */
  prune(): void {
    this.#pass.prune(new Set(this.#cells.flatMap((cell) => (cell ? [cell.face.areas] : []))))
  }

  /**
   * Called before a face is drawn. The first face of a frame brings all those up to date that the last frame saw, in
   * one go; a face that comes into sight later in the frame comes alone.
   */
  update(cells: readonly Cell[], renderer: AnyRenderer): void {
    this.#notice(renderer)
    if (renderCount(renderer) !== this.#renders) this.#nextFrame(renderer)
    for (const cell of cells) {
      if (cell.updated !== this.#frame) this.#bring(cell, renderer)
      cell.seen = this.#frame
    }
    if (this.#changes > 0) this.#pass.draw(renderer, this.#changed, this.#changes)
    this.#changes = 0
    this.#renders = renderCount(renderer)
  }

  dispose(): void {
    this.target.dispose()
    this.#pass.dispose()
  }

  #nextFrame(renderer: AnyRenderer): void {
    const last = this.#frame++
    for (const cell of this.#cells)
      if (cell && (cell.seen === last || cell.updated < 0)) this.#bring(cell, renderer)
  }

  #bring(cell: Cell, renderer: AnyRenderer): void {
    cell.updated = this.#frame
    cell.face.drive(renderer)
    if (isOld(cell)) this.#changed[this.#changes++] = cell
  }

  /** Another renderer, or a context that was lost, has nothing of what was drawn. */
  #notice(renderer: AnyRenderer): void {
    if (renderer === this.#renderer && this.#pass.hasContents(renderer)) return
    this.#renderer = renderer
    this.#forget()
  }

  #forget(): void {
    for (const cell of this.#cells) if (cell) cell.stale = true
  }

  #room(count: number): number {
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
        who: 'Wrinkles',
        what: 'too many faces with influence maps of this size',
        value: `${count} of ${this.width} x ${this.height} texels`,
        limit: `a texture of ${LARGEST_SIDE} x ${LARGEST_SIDE} for all`,
        remedy: 'give the faces of a crowd smaller areas (areaSize)',
      })
    }
    Object.assign(this.grid, { columns, rows })
    this.target.setSize(columns * this.width, rows * this.height)
    this.#forget()
  }
}

/** Grows with every call of `render`, those within another included. */
function renderCount({ info }: AnyRenderer): number {
  return 'calls' in info ? info.calls : info.render.frame
}

function isOld({ face, drawn, stale }: Cell): boolean {
  if (stale) return true
  const { values } = face
  const count = face.areas.slots.length
  for (let i = 0; i < count; i++) if (hasMoved(values[i], drawn[i])) return true
  return false
}

/**
 * Whether an activation is to be drawn anew. An area that comes or goes counts however little it moved: where it is 0, skin is
 * smooth to the last bit.
 */
export function hasMoved(value: number, drawn: number): boolean {
  const change = Math.abs(value - drawn)
  return change > LEAST_CHANGE || (change > 0 && (value === 0 || drawn === 0))
}
