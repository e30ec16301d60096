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

/** More channels of whole floats than these take graphics cards several steps to filter. */
const MOST_WHOLE_FLOATS = 2

/** Quads that clear cells, or those of one array's areas with one rule. */
interface Batch {
  rule: QuadRule
  areas: AreaArray | null
  quads: Quads
}

/**
 * The influence maps of all faces of one kind, side by side in one texture: per layer, the sum of a face's areas times their
 * activations, in UV space at the areas' resolution. A cell is redrawn only when an activation of its face has changed, and then only
 * over the rectangles of active areas; one pass draws all cells of a frame. Shaders of faces take one sample of it, however many areas
 * there are.
 *
 * Texels hold T = max(sum, largest `max`), unclamped; shaders take min(1, T) after interpolation, and so clamp exactly where the reference
 * does. They are whole floats where these can be filtered and added up, else half ones: a software rasteriser has to convert halves,
 * four of them for each sample, which costs as much as a texture of bytes. Bytes cannot hold what passes 1.
 */
export class InfluenceAtlas implements InfluenceTarget<AnyRenderer> {
  readonly layers: number
  readonly target: RenderTarget
  readonly cells: AtlasCells
  readonly #materials: QuadMaterials
  readonly #scene = new Scene()
  readonly #camera = new OrthographicCamera()
  /** All of a cell. */
  readonly #whole: AreaSlot
  /** A list rather than a map: iterating it allocates nothing. */
  #batches: Batch[] = []
  #renderer: AnyRenderer | null = null
  /** The renderer that has compiled what draws areas. */
  #compiled: AnyRenderer | null = null
  /** What drew cells that were collected together: each renderer has a texture of its own, with the cells of the faces that it draws. */
  readonly #drawnBy = new WeakMap<readonly Cell[], AnyRenderer>()

  /**
   * @param width of a cell and of the faces' areas, in texels.
   * @param height the same.
   * @param layers number of the faces' layers, with one channel each.
   */
  constructor(width: number, height: number, layers: number, materials: QuadMaterials) {
    this.layers = layers
    this.cells = new AtlasCells(width, height)
    this.target = new RenderTarget(width, height, {
      format: FORMATS[layers - 1],
      type: HalfFloatType,
      depthBuffer: false,
    })
    // `WebGPURenderer` sets it when it makes its own texture of a target, and others would make theirs anew, within what they draw already.
    Object.defineProperty(this.target.texture, 'needsUpdate', { set: () => {} })
    this.#materials = materials
    this.#scene.matrixWorldAutoUpdate = false
    const bounds = { x0: 0, y0: 0, x1: width, y1: height }
    this.#whole = { layer: 0, combine: 'sum', slice: 0, channel: 0, bounds }
  }

  /**
   * Allocates consecutive cells to faces.
   *
   * @throws FurrowError when they do not fit into the largest texture.
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

  /** Frees cells. */
  remove(cells: readonly Cell[]): void {
    this.cells.remove(cells)
    this.#prune()
  }

  /** Gives the faces of cells other areas. */
  rebind(cells: readonly Cell[], array: AreaArray, areas: readonly { name: string }[]): void {
    for (const cell of cells) {
      cell.face.rebind(array, areas)
      cell.version = STALE
    }
    this.#prune()
  }

  /** Frees the resources of arrays of areas that no face uses any more. */
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

  /** Collects those of some cells that have changed, for `draw`. */
  collect(cells: readonly Cell[], renderer: AnyRenderer): void {
    this.#checkContents(renderer)
    if (this.#drawnBy.get(cells) !== renderer) {
      this.#drawnBy.set(cells, renderer)
      for (const cell of cells) cell.version = STALE
    }
    this.cells.collect(cells)
  }

  /** Draws the cells that were collected, with their faces' activations. */
  draw(renderer: AnyRenderer): void {
    const { changed, changes, isWhole } = this.cells
    if (changes === 0) return
    for (const { quads } of this.#batches) quads.begin()
    for (let i = 0; i < changes; i++) this.#put(changed[i], isWhole)
    for (const { areas, quads } of this.#batches) {
      quads.end()
      if (areas && quads.mesh.visible) this.#compiled = renderer
    }
    // In one stroke, without a quad for each cell and a program for these: a page with one face never takes one.
    renderPreservingState(renderer, this.target, this.#scene, this.#camera, 0, isWhole)
    this.cells.changes = 0
  }

  /** Compiles what draws areas, unless some were drawn already. Between frames only. */
  compile(renderer: WebGLRenderer): void {
    if (renderer === this.#compiled) return
    this.#compiled = renderer
    this.#quadsOf('clear', null)
    for (const areas of this.cells.slots as Set<AreaArray>)
      for (const { combine } of areas.slots) this.#quadsOf(combine, areas)
    const before = renderer.getRenderTarget()
    renderer.setRenderTarget(this.target as never)
    // Nobody waits for it, as `compileAsync` would, which warns of drivers that do not compile beside the page.
    renderer.compile(this.#scene, this.#camera)
    renderer.setRenderTarget(before)
  }

  dispose(): void {
    this.target.dispose()
    for (const { quads } of this.#batches) quads.dispose()
  }

  /** What was drawn is missing after a lost context. */
  #checkContents(renderer: AnyRenderer): void {
    if (renderer !== this.#renderer) this.#checkType(renderer)
    this.#renderer = renderer
    if (!this.#materials.hasContents(renderer, this.target)) this.cells.invalidate()
  }

  #checkType(renderer: AnyRenderer): void {
    const type = this.layers <= MOST_WHOLE_FLOATS && filtersFloats(renderer) ? FloatType : HalfFloatType
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
