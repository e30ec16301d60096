import { type Material, OrthographicCamera, type RenderTarget, Scene } from 'three'
import type { AreaSlot } from '../../runtime/area-slots.ts'
import type { AtlasCells, Cell } from '../../runtime/atlas-cells.ts'
import type { AnyRenderer } from '../renderer.ts'
import type { AreaArray } from './area-array.ts'
import { Quads } from './quads.ts'
import { clearPreservingState, compileFor, renderPreservingState } from './render-preserving-state.ts'

/** What depends on the renderer: the quads' materials, and whether a target still holds what was drawn. */
export interface QuadMaterials {
  /** A material that writes 0, adds weight x activation, or takes the maximum with it; see `Quads` for the attributes. */
  create(rule: 'clear' | 'sum' | 'max', areas: AreaArray | null): Material
  /** False after the renderer's context was lost. */
  hasContents(renderer: AnyRenderer, target: RenderTarget): boolean
}

/** Quads of the areas of one array. */
interface Batch {
  areas: AreaArray
  sum: Quads
  max: Quads
}

/** Draws cells of an atlas: clears them, adds up their areas, and takes the maximum with those that combine by `max`. */
export class InfluencePass {
  readonly #cells: AtlasCells
  readonly #target: RenderTarget
  readonly #materials: QuadMaterials
  readonly #scene = new Scene()
  readonly #camera = new OrthographicCamera()
  readonly #cleared: Quads
  readonly #whole: AreaSlot
  /** A list rather than a map: iterating it allocates nothing. */
  #batches: Batch[] = []

  constructor(cells: AtlasCells, target: RenderTarget, materials: QuadMaterials) {
    this.#cells = cells
    this.#target = target
    this.#materials = materials
    this.#scene.matrixWorldAutoUpdate = false
    this.#cleared = this.#quads('clear', null)
    const bounds = { x0: 0, y0: 0, x1: cells.width, y1: cells.height }
    this.#whole = { layer: 0, combine: 'sum', slice: 0, channel: 0, bounds }
  }

  /** Whether the target still holds what was drawn. */
  hasContents(renderer: AnyRenderer): boolean {
    return this.#materials.hasContents(renderer, this.#target)
  }

  /** Draws the first `count` of some cells with their faces' activations. */
  draw(renderer: AnyRenderer, cells: readonly Cell[], count: number): void {
    const { isWhole } = this.#cells
    this.#cleared.begin()
    for (const { sum, max } of this.#batches) {
      sum.begin()
      max.begin()
    }
    for (let i = 0; i < count; i++) this.#put(cells[i], isWhole)
    this.#cleared.end()
    for (const { sum, max } of this.#batches) {
      sum.end()
      max.end()
    }
    // In one stroke, without a quad for each cell and a program for these: a page with one face never takes one.
    if (isWhole) clearPreservingState(renderer, this.#target)
    renderPreservingState(renderer, this.#target, this.#scene, this.#camera)
  }

  /** Compiles what draws some arrays of areas. */
  compile(renderer: AnyRenderer, used: ReadonlySet<AreaArray>): void {
    for (const areas of used) this.#batchOf(areas)
    // Whatever is wrong, the first frame tells.
    compileFor(renderer, this.#target, this.#scene, this.#camera).catch(() => {})
  }

  /** Frees the resources of all other arrays of areas. */
  prune(used: ReadonlySet<AreaArray>): void {
    for (const { sum, max } of this.#batches.filter(({ areas }) => !used.has(areas))) {
      for (const quads of [sum, max]) {
        this.#scene.remove(quads.mesh)
        quads.dispose()
      }
    }
    this.#batches = this.#batches.filter(({ areas }) => used.has(areas))
  }

  dispose(): void {
    this.prune(new Set())
    this.#cleared.dispose()
  }

  #put(cell: Cell, isClear: boolean): void {
    const { face, drawn, index } = cell
    const { grid } = this.#cells
    const column = index % grid.columns
    const row = Math.floor(index / grid.columns)
    if (!isClear) this.#cleared.put(column, row, this.#whole, 0)
    const areas = face.slots as AreaArray
    const { sum, max } = this.#batchOf(areas)
    const { slots } = areas
    const { values } = face.activations
    for (let i = 0; i < slots.length; i++) {
      const value = values[i]
      drawn[i] = value
      const slot = slots[i]
      if (value === 0 || slot.bounds.x1 <= slot.bounds.x0) continue
      const quads = slot.combine === 'max' ? max : sum
      quads.put(column, row, slot, value)
    }
    cell.version = areas.version
    cell.stale = false
  }

  #batchOf(areas: AreaArray): Batch {
    for (const batch of this.#batches) if (batch.areas === areas) return batch
    const batch = { areas, sum: this.#quads('sum', areas), max: this.#quads('max', areas) }
    this.#batches.push(batch)
    batch.sum.begin()
    batch.max.begin()
    return batch
  }

  #quads(rule: 'clear' | 'sum' | 'max', areas: AreaArray | null): Quads {
    const quads = new Quads(this.#cells, this.#materials.create(rule, areas))
    // All cells are cleared before sums are added, and sums are complete before the maximum.
    quads.mesh.renderOrder = { clear: 0, sum: 1, max: 2 }[rule]
    this.#scene.add(quads.mesh)
    return quads
  }
}
