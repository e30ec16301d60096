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

/** Maximum number of channels for which 32-bit floats are used: GPUs filter float textures with more channels at a reduced rate. */
const MAX_FLOAT_CHANNELS = 2

/** Quads that are drawn together: they clear cells, or draw areas of one texture array that combine in the same way. */
interface Batch {
  rule: QuadRule
  areas: AreaArray | null
  quads: Quads
}

/**
 * Influence maps of all faces with one area size and layer count, one cell per face. A map holds, per layer, the sum of the face's areas
 * times their activations, in UV space. A cell is redrawn only when an activation of its face changes, over the rectangles of active
 * areas. One pass draws all changed cells of a frame. Face shaders take one sample, for any number of areas.
 *
 * A texel holds the larger of two values, unclamped: the sum over areas that combine by `sum`, and the maximum over areas that combine by
 * `max`. Shaders clamp the value to 1 after interpolation, like the reference implementation.
 * The type is 32-bit float if the GPU can filter and blend it, because software rasterisers convert each half float. Otherwise it is half
 * float: bytes cannot hold values above 1.
 */
export class InfluenceAtlas implements InfluenceTarget<AnyRenderer> {
  readonly layers: number
  readonly target: RenderTarget
  readonly cells: AtlasCells
  readonly #materials: QuadMaterials
  readonly #scene = new Scene()
  readonly #camera = new OrthographicCamera()
  /** Rectangle that covers a complete cell. */
  readonly #cellSlot: AreaSlot
  /** Array, because iterating a Map allocates. */
  #batches: Batch[] = []
  #renderer: AnyRenderer | null = null
  /** Renderer that has compiled the area programs. */
  #compiled: AnyRenderer | null = null
  /** Renderer that last drew each group of cells. Each renderer has its own GPU texture, which holds only the cells that it drew. */
  readonly #drawnBy = new WeakMap<readonly Cell[], AnyRenderer>()

  /**
   * @param width width of a cell and of the faces' areas, texels.
   * @param height height of a cell and of the faces' areas, texels.
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
    // `WebGPURenderer` sets `needsUpdate` when it creates its texture of a target; other renderers would then recreate theirs while drawing.
    Object.defineProperty(this.target.texture, 'needsUpdate', { set: () => {} })
    this.#materials = materials
    this.#scene.matrixWorldAutoUpdate = false
    const bounds = { x0: 0, y0: 0, x1: width, y1: height }
    this.#cellSlot = { layer: 0, combine: 'sum', slice: 0, channel: 0, bounds }
  }

  /**
   * Allocates consecutive cells for faces.
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

  /** Switches the faces of cells to another area array. */
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

  /** Collects the changed cells among `cells`, for `draw`. */
  collect(cells: readonly Cell[], renderer: AnyRenderer): void {
    this.#checkContents(renderer)
    if (this.#drawnBy.get(cells) !== renderer) {
      this.#drawnBy.set(cells, renderer)
      for (const cell of cells) cell.version = STALE
    }
    this.cells.collect(cells)
  }

  /** Draws the collected cells with their faces' activations. */
  draw(renderer: AnyRenderer): void {
    const { changed, changes, allChanged } = this.cells
    if (changes === 0) return
    for (const { quads } of this.#batches) quads.begin()
    for (let i = 0; i < changes; i++) this.#put(changed[i], allChanged)
    for (const { areas, quads } of this.#batches) {
      quads.end()
      if (areas && quads.mesh.visible) this.#compiled = renderer
    }
    // Clears the complete target at once if possible: pages with one face then never compile the clear program.
    renderPreservingState(renderer, this.target, this.#scene, this.#camera, 0, allChanged)
    this.cells.changes = 0
  }

  /** Compiles the area programs, unless areas were already drawn. Call between frames only. */
  compile(renderer: WebGLRenderer): void {
    if (renderer === this.#compiled) return
    this.#compiled = renderer
    this.#quadsOf('clear', null)
    for (const areas of this.cells.slots as Set<AreaArray>)
      for (const { combine } of areas.slots) this.#quadsOf(combine, areas)
    const before = renderer.getRenderTarget()
    renderer.setRenderTarget(this.target as never)
    // Not `compileAsync`: nothing awaits the result, and it warns if the driver has no parallel compilation.
    renderer.compile(this.#scene, this.#camera)
    renderer.setRenderTarget(before)
  }

  dispose(): void {
    this.target.dispose()
    for (const { quads } of this.#batches) quads.dispose()
  }

  /** Invalidates cells whose contents were lost with the context. */
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
