import {
  FloatType,
  HalfFloatType,
  OrthographicCamera,
  RedFormat,
  RenderTarget,
  RGBAFormat,
  RGFormat,
  Scene,
  type WebGLRenderer,
} from 'three'
import type { AreaSlot } from '../../runtime/area-slots.ts'
import { AtlasCells, type Cell, STALE } from '../../runtime/atlas-cells.ts'
import type { Face } from '../../runtime/face.ts'
import type { InfluenceTarget } from '../../runtime/frame.ts'
import { type AnyRenderer, filtersFloats } from '../renderer.ts'
import type { AreaArray } from './area-array.ts'
import { QUAD_RULES, type QuadMaterials, type QuadRule } from './quad-materials.ts'
import { Quads } from './quads.ts'
import { renderPreservingState } from './render-preserving-state.ts'

const FORMATS = [RedFormat, RGFormat, RGBAFormat, RGBAFormat] as const

/** Maximum number of channels of a 32-bit float texture. GPUs filter float textures with more channels at a reduced rate. */
const MAX_FLOAT_CHANNELS = 2

/** Rectangles of one draw call. They either clear cells, or draw areas of one texture array with one blend equation. */
interface Batch {
  rule: QuadRule
  areas: AreaArray | null
  quads: Quads
}

/**
 * Texture with the influence maps of several faces. An area is a group of wrinkles with weights in UV space and an activation, 0..1. An influence
 * map combines, per layer of wrinkles, the weights of all areas times their activations. All faces in an atlas have the same number of
 * layers, and the weights of their areas have the same size in texels. Each face has one rectangle of the texture, its cell. A cell is redrawn
 * when an activation of its face changes, and one render pass redraws all changed cells of a frame. The shader of a face takes one sample of
 * its cell, regardless of the number of areas.
 *
 * Each area contributes its weight times its activation. A texel holds the sum of the contributions of areas that combine by `sum`, or the
 * largest contribution of the areas that combine by `max`, whichever is larger. The value may exceed 1. Shaders clamp it to 1 after
 * interpolation, like the reference implementation.
 *
 * With one or two layers, texels are 32-bit floats if the GPU can filter and blend them, because software rasterisers are slower with half
 * floats. Otherwise texels are half floats. 8-bit texels cannot hold values above 1.
 */
export class InfluenceAtlas implements InfluenceTarget<AnyRenderer> {
  readonly layers: number
  readonly target: RenderTarget
  readonly cells: AtlasCells
  readonly #materials: QuadMaterials
  readonly #scene = new Scene()
  readonly #camera = new OrthographicCamera()
  /** Rectangle that covers a complete cell. `Quads` draws it to clear the cell. */
  readonly #cellSlot: AreaSlot
  /** An array instead of a Map, because iterating a Map allocates. */
  #batches: Batch[] = []
  #renderer: AnyRenderer | null = null
  /** Renderer that has compiled the shaders that draw areas. */
  #compiled: AnyRenderer | null = null
  /**
   * Renderer that last drew the cells of each mesh. Each renderer has its own GPU texture, and that texture holds only the cells that the
   * renderer drew.
   */
  readonly #drawnBy = new WeakMap<readonly Cell[], AnyRenderer>()

  /**
   * @param width width of a cell and of the weight maps of areas, texels.
   * @param height height of a cell and of the weight maps of areas, texels.
   * @param layers number of layers, one channel each.
   */
  constructor(width: number, height: number, layers: number, materials: QuadMaterials) {
    this.layers = layers
    this.cells = new AtlasCells(width, height)
    this.target = new RenderTarget(width, height, {
      format: FORMATS[layers - 1],
      type: HalfFloatType,
      depthBuffer: false,
    })
    // `WebGPURenderer` sets `needsUpdate` when it creates a GPU texture. The override ignores this, because any other renderer that draws the
    // target would recreate its GPU texture while drawing.
    Object.defineProperty(this.target.texture, 'needsUpdate', { set: () => {} })
    this.#materials = materials
    this.#scene.matrixWorldAutoUpdate = false
    const bounds = { x0: 0, y0: 0, x1: width, y1: height }
    this.#cellSlot = { layer: 0, combine: 'sum', slice: 0, channel: 0, bounds }
  }

  /**
   * Allocates consecutive cells for faces, and enlarges the texture if needed.
   *
   * @throws FurrowError if the cells do not fit into the largest texture.
   */
  add(faces: readonly Face[]): Cell[] {
    const added = this.cells.add(faces)
    const { width, height, grid } = this.cells
    const across = grid.columns * width
    const down = grid.rows * height
    if (across !== this.target.width || down !== this.target.height) this.target.texture.version++
    this.target.setSize(across, down)
    return added
  }

  remove(cells: readonly Cell[]): void {
    this.cells.remove(cells)
    this.#prune()
  }

  rebind(cells: readonly Cell[], array: AreaArray, areas: readonly { name: string }[]): void {
    for (const cell of cells) {
      cell.face.rebind(array, areas)
      cell.version = STALE
    }
    this.#prune()
  }

  /** Frees resources of area arrays that no face uses. */
  #prune(): void {
    const used = this.cells.slots as Set<AreaArray>
    this.#batches = this.#batches.filter(({ areas, quads }) => {
      const isKept = !areas || used.has(areas)
      if (!isKept) {
        this.#scene.remove(quads.mesh)
        quads.dispose()
      }
      return isKept
    })
  }

  /** Adds the changed cells among `cells` to the cells that `draw` will redraw. */
  collect(cells: readonly Cell[], renderer: AnyRenderer): void {
    this.#checkContents(renderer)
    if (this.#drawnBy.get(cells) !== renderer) {
      this.#drawnBy.set(cells, renderer)
      for (const cell of cells) cell.version = STALE
    }
    this.cells.collect(cells)
  }

  draw(renderer: AnyRenderer): void {
    const { changed, changes, allChanged } = this.cells
    if (changes === 0) return
    for (const { quads } of this.#batches) quads.begin()
    for (let i = 0; i < changes; i++) this.#put(changed[i], allChanged)
    for (const { areas, quads } of this.#batches) {
      quads.end()
      if (areas && quads.mesh.visible) this.#compiled = renderer
    }
    // If all cells change, the complete target is cleared at once. Pages with one face then never compile the shader that clears cells.
    renderPreservingState(renderer, this.target, this.#scene, this.#camera, 0, allChanged)
    this.cells.changes = 0
  }

  /** Compiles the shaders that draw areas, unless areas were already drawn. Call between frames only. */
  compile(renderer: WebGLRenderer): void {
    if (renderer === this.#compiled) return
    this.#compiled = renderer
    this.#quadsOf('clear', null)
    for (const areas of this.cells.slots as Set<AreaArray>)
      for (const { combine } of areas.slots) this.#quadsOf(combine, areas)
    const before = renderer.getRenderTarget()
    renderer.setRenderTarget(this.target as never)
    // Not `compileAsync`, because it logs a warning if the GPU driver cannot compile in parallel.
    renderer.compile(this.#scene, this.#camera)
    renderer.setRenderTarget(before)
  }

  dispose(): void {
    this.target.dispose()
    for (const { quads } of this.#batches) quads.dispose()
  }

  /** Marks all cells as changed if the target lost its contents, e.g. with the WebGL context. */
  #checkContents(renderer: AnyRenderer): void {
    if (renderer !== this.#renderer) this.#checkType(renderer)
    this.#renderer = renderer
    if (!this.#materials.hasContents(renderer, this.target)) this.cells.invalidate()
  }

  #checkType(renderer: AnyRenderer): void {
    const type = this.layers <= MAX_FLOAT_CHANNELS && filtersFloats(renderer) ? FloatType : HalfFloatType
    if (this.target.texture.type === type) return
    this.target.texture.type = type
    this.target.texture.version++
    this.target.dispose()
    this.cells.invalidate()
  }

  #put(cell: Cell, isClear: boolean): void {
    const { face, drawn, index } = cell
    const { grid } = this.cells
    const column = index % grid.columns
    const row = Math.floor(index / grid.columns)
    if (!isClear) this.#quadsOf('clear', null).put(column, row, this.#cellSlot, 0)
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
  }

  #quadsOf(rule: QuadRule, areas: AreaArray | null): Quads {
    for (const batch of this.#batches) if (batch.rule === rule && batch.areas === areas) return batch.quads
    const quads = new Quads(this.cells, this.#materials.create(rule, areas))
    quads.mesh.renderOrder = QUAD_RULES.indexOf(rule)
    this.#scene.add(quads.mesh)
    this.#batches.push({ rule, areas, quads })
    return quads
  }
}
