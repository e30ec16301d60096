import { type Material, OrthographicCamera, type RenderTarget, Scene } from 'three'
import type { AreaArray, Slot } from './area-array.ts'
import type { AnyRenderer, Cell, InfluenceAtlas } from './influence-atlas.ts'
import { Quads } from './quads.ts'
import { drawAside } from './render-preserving-state.ts'

/** What a renderer's class adds: materials of the quads, and whether a target still holds what was drawn. */
export interface QuadMaterials {
  /** Writes 0, or adds the areas' shares up, or takes the largest; see `Quads` for the attributes. */
  create(rule: 'clear' | 'sum' | 'max', areas: AreaArray | null): Material
  hasContents(renderer: AnyRenderer, drawn: { readonly target: RenderTarget }): boolean
}

/** Quads of the areas of one array. */
interface Batch {
  areas: AreaArray
  sum: Quads
  max: Quads
}

/** Draws cells of an atlas: clears them, adds up their areas, and takes the largest of those that say so. */
export class InfluencePass {
  readonly #atlas: InfluenceAtlas
  readonly #materials: QuadMaterials
  readonly #scene = new Scene()
  readonly #camera = new OrthographicCamera()
  readonly #cleared: Quads
  readonly #whole: Slot
  /** A list and no map: going through it allocates nothing. */
  #batches: Batch[] = []

  constructor(atlas: InfluenceAtlas, materials: QuadMaterials) {
    this.#atlas = atlas
    this.#materials = materials
    this.#scene.matrixWorldAutoUpdate = false
    this.#cleared = this.#quads('clear', null)
    const bounds = { x0: 0, y0: 0, x1: atlas.width, y1: atlas.height }
    this.#whole = { layer: 0, combine: 'sum', slice: 0, channel: 0, bounds }
  }

  hasContents(renderer: AnyRenderer): boolean {
    return this.#materials.hasContents(renderer, this.#atlas)
  }

  /** @param cells of which the first `count` have activations as they shall be drawn; their `drawn` is set. */
  draw(renderer: AnyRenderer, cells: readonly Cell[], count: number): void {
    this.#cleared.begin()
    for (const { sum, max } of this.#batches) {
      sum.begin()
      max.begin()
    }
    for (let i = 0; i < count; i++) this.#put(cells[i])
    this.#cleared.end()
    for (const { sum, max } of this.#batches) {
      sum.end()
      max.end()
    }
    drawAside(renderer, this.#atlas.target, this.#scene, this.#camera)
  }

  /** Frees what belongs to arrays of areas that no face has any more. */
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

  #put(cell: Cell): void {
    const { face, drawn, index } = cell
    const { grid } = this.#atlas
    const column = index % grid.columns
    const row = Math.floor(index / grid.columns)
    this.#cleared.put(column, row, this.#whole, 0)
    const { sum, max } = this.#batchOf(face.areas)
    const { slots } = face.areas
    for (let i = 0; i < slots.length; i++) {
      const value = face.values[i]
      drawn[i] = value
      const slot = slots[i]
      if (value === 0 || slot.bounds.x1 <= slot.bounds.x0) continue
      const quads = slot.combine === 'max' ? max : sum
      quads.put(column, row, slot, value)
    }
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
    const quads = new Quads(this.#atlas, this.#materials.create(rule, areas))
    // All are cleared before any is added to, and added up before the largest is taken.
    quads.mesh.renderOrder = { clear: 0, sum: 1, max: 2 }[rule]
    this.#scene.add(quads.mesh)
    return quads
  }
}
