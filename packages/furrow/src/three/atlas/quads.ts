import {
  BufferGeometry,
  DynamicDrawUsage,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  type Material,
  Mesh,
} from 'three'
import type { AreaSlot } from '../../runtime/area-slots.ts'

/** Floats per vertex: a vec4 (`furrowPoint`) and a vec2 (`furrowSource`). */
const STRIDE = 6
const CORNERS = 4
/** Maximum number of channels per slice, and maximum number of layers. */
const CHANNELS = 4
const LAYERS = 4

/** Grid of cells in the atlas; each cell has `width` x `height` texels. */
interface CellGrid {
  readonly width: number
  readonly height: number
  readonly grid: { readonly columns: number; readonly rows: number }
}

/**
 * Mesh of rectangles that draw areas into the cells of the influence atlas. An area is a group of wrinkles, with an image of weights in UV
 * space and an activation, 0..1. The atlas is a texture with one cell per face, see `InfluenceAtlas`.
 *
 * The vertex attribute `furrowPoint` holds the position in the atlas (xy, 0..1) and the position in the area's image (zw, texels).
 * `furrowSource` holds the activation (x), and the location of the area and its layer as `(slice * 4 + channel) * 4 + layer` (y).
 *
 * The rectangles are not instanced. GPUs shade dozens of vertices of one instance in parallel, so instances of four vertices would leave most
 * of the GPU idle. Software rasterisers treat each instance as a draw call.
 */
export class Quads {
  readonly mesh: Mesh<BufferGeometry, Material>
  readonly #cells: CellGrid
  #data = new Float32Array(16 * CORNERS * STRIDE)
  #buffer!: InterleavedBuffer
  readonly #used = { start: 0, count: 0 }

  constructor(cells: CellGrid, material: Material) {
    this.#cells = cells
    this.mesh = new Mesh<BufferGeometry, Material>(undefined, material)
    this.mesh.frustumCulled = false
    this.mesh.matrixAutoUpdate = false
    this.#bind()
  }

  begin(): void {
    this.#used.count = 0
  }

  /** Adds the rectangle of one area to the cell at `column` and `row`. */
  put(column: number, row: number, { bounds, slice, channel, layer }: AreaSlot, activation: number): void {
    if (this.#used.count === this.#data.length) this.#grow()
    const { width, height, grid } = this.#cells
    const data = this.#data
    let at = this.#used.count
    const source = (slice * CHANNELS + channel) * LAYERS + layer
    // Size of a texel relative to the atlas.
    const texelWidth = 1 / (width * grid.columns)
    const texelHeight = 1 / (height * grid.rows)
    for (let corner = 0; corner < CORNERS; corner++) {
      const x = corner & 1 ? bounds.x1 : bounds.x0
      const y = corner & 2 ? bounds.y1 : bounds.y0
      data[at] = (column * width + x) * texelWidth
      data[at + 1] = (row * height + y) * texelHeight
      data[at + 2] = x
      data[at + 3] = y
      data[at + 4] = activation
      data[at + 5] = source
      at += STRIDE
    }
    this.#used.count = at
  }

  end(): void {
    const { count } = this.#used
    this.mesh.visible = count > 0
    this.mesh.geometry.drawRange.count = (count / (CORNERS * STRIDE)) * 6
    // three.js empties `updateRanges` after the upload. One range object is reused, to avoid an allocation.
    if (this.#buffer.updateRanges.length === 0) this.#buffer.updateRanges.push(this.#used)
    this.#buffer.needsUpdate = true
  }

  dispose(): void {
    this.mesh.geometry.dispose()
    this.mesh.material.dispose()
  }

  #grow(): void {
    const data = new Float32Array(2 * this.#data.length)
    data.set(this.#data)
    this.#data = data
    this.#bind()
  }

  /** Creates a new geometry for the current buffer, because GPU buffers cannot grow. */
  #bind(): void {
    this.mesh.geometry.dispose()
    const geometry = new BufferGeometry()
    const length = (this.#data.length / (CORNERS * STRIDE)) * 6
    geometry.setIndex(Array.from({ length }, (_, i) => CORNERS * Math.floor(i / 6) + TRIANGLES[i % 6]))
    this.#buffer = new InterleavedBuffer(this.#data, STRIDE)
    this.#buffer.setUsage(DynamicDrawUsage)
    geometry.setAttribute('furrowPoint', new InterleavedBufferAttribute(this.#buffer, 4, 0))
    geometry.setAttribute('furrowSource', new InterleavedBufferAttribute(this.#buffer, 2, 4))
    this.mesh.geometry = geometry
  }
}

/** Corner indices of the two triangles of a rectangle. */
const TRIANGLES = [0, 1, 2, 2, 1, 3]
