import { type Material, OrthographicCamera, type RenderTarget, Scene } from 'three'
import type { AreaSlot } from '../../runtime/area-slots.ts'
import type { AtlasCells, Cell } from '../../runtime/atlas-cells.ts'
import type { AnyRenderer } from '../renderer.ts'
import type { AreaArray } from './area-array.ts'
import { Quads } from './quads.ts'
import { compileFor, renderPreservingState } from './render-preserving-state.ts'

/** In this order: all cells are cleared before sums are added, and sums are complete before the maximum. */
const RULES = ['clear', 'sum', 'max'] as const
type Rule = (typeof RULES)[number]

/** What depends on the renderer: the quads' materials, and whether a target still holds what was drawn. */
export interface QuadMaterials {
  /** A material that writes 0, adds weight x activation, or takes the maximum with it; see `Quads` for the attributes. */
  create(rule: Rule, areas: AreaArray | null): Material
  /** False after the renderer's context was lost. */
  hasContents(renderer: AnyRenderer, target: RenderTarget): boolean
}

/** Quads that clear cells, or those of one array's areas with one rule. */
interface Batch {
  rule: Rule
  areas: AreaArray | null
  quads: Quads
}

/** Draws cells of an atlas: clears them, adds up their areas, and takes the maximum with those that combine by `max`. */
export class InfluencePass {
  readonly #cells: AtlasCells
  readonly #target: RenderTarget
  readonly #materials: QuadMaterials
  readonly #scene = new Scene()
  readonly #camera = new OrthographicCamera()
  readonly #whole: AreaSlot
  /** A list rather than a map: iterating it allocates nothing. */
  #batches: Batch[] = []

  constructor(cells: AtlasCells, target: RenderTarget, materials: QuadMaterials) {
    this.#cells = cells
    this.#target = target
    this.#materials = materials
    this.#scene.matrixWorldAutoUpdate = false
    const bounds = { x0: 0, y0: 0, x1: cells.width, y1: cells.height }
    this.#whole = { layer: 0, combine: 'sum', slice: 0, channel: 0, bounds }
  }

  /** Whether the target still holds what was drawn. */
  hasContents(renderer: AnyRenderer): boolean {
    return this.#materials.hasContents(renderer, this.#target)
  }

  /** Draws the first `count` of some cells with their faces' activations. */
  draw(renderer: AnyRenderer, cells: readonly Cell[], count: number): void {
    // In one stroke, without a quad for each cell and a program for these: a page with one face never takes one.
    const { isWhole } = this.#cells
    for (const { quads } of this.#batches) quads.begin()
    for (let i = 0; i < count; i++) this.#put(cells[i], isWhole)
    for (const { quads } of this.#batches) quads.end()
    renderPreservingState(renderer, this.#target, this.#scene, this.#camera, 0, isWhole)
  }

  /** Compiles what draws some arrays of areas. */
  compile(renderer: AnyRenderer, used: ReadonlySet<AreaArray>): void {
    this.#quadsOf('clear', null)
    for (const areas of used) for (const { combine } of areas.slots) this.#quadsOf(combine, areas)
    // Whatever is wrong, the first frame tells.
    compileFor(renderer, this.#target, this.#scene, this.#camera).catch(() => {})
  }

  /** Frees the resources of all other arrays of areas. */
  prune(used: ReadonlySet<AreaArray>): void {
    this.#batches = this.#batches.filter(({ areas, quads }) => {
      const isKept = !areas || used.has(areas)
      if (!isKept) {
        this.#scene.remove(quads.mesh)
        quads.dispose()
      }
      return isKept
    })
  }

  dispose(): void {
    for (const { quads } of this.#batches) quads.dispose()
  }

  #put(cell: Cell, isClear: boolean): void {
    const { face, drawn, index } = cell
    const { grid } = this.#cells
    const column = index % grid.columns
    const row = Math.floor(index / grid.columns)
    if (!isClear) this.#quadsOf('clear', null).put(column, row, this.#whole, 0)
    const areas = face.slots as AreaArray
    const sum = this.#quadsOf('sum', areas)
    const { slots } = areas
    const { values } = face.activations
    for (let i = 0; i < slots.length; i++) {
      const value = values[i]
      drawn[i] = value
      const slot = slots[i]
      if (value === 0 || slot.bounds.x1 <= slot.bounds.x0) continue
      const quads = slot.combine === 'max' ? this.#quadsOf('max', areas) : sum
      quads.put(column, row, slot, value)
    }
    cell.version = areas.version
    cell.stale = false
  }

  #quadsOf(rule: Rule, areas: AreaArray | null): Quads {
    for (const batch of this.#batches) if (batch.rule === rule && batch.areas === areas) return batch.quads
    const quads = new Quads(this.#cells, this.#materials.create(rule, areas))
    quads.mesh.renderOrder = RULES.indexOf(rule)
    this.#scene.add(quads.mesh)
    this.#batches.push({ rule, areas, quads })
    return quads
  }
}
