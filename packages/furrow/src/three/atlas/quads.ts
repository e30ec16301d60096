import {
  BufferAttribute,
  DynamicDrawUsage,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  type Material,
  Mesh,
} from 'three'
import { MAX_LAYERS } from '../../core/limits.ts'
import type { AreaSlot } from '../../runtime/area-slots.ts'

/** Four vectors of four numbers for each instance. */
const ATTRIBUTES = ['furrowTarget', 'furrowTexels', 'furrowSource', 'furrowActivation'] as const
const STRIDE = 4 * ATTRIBUTES.length

/** What they are drawn onto: a grid of cells, each `width` x `height` texels of an area. */
interface CellGrid {
  readonly width: number
  readonly height: number
  readonly grid: { readonly columns: number; readonly rows: number }
}

/**
 * Rectangles drawn as instances of one square, whose corners are 0 or 1. Attributes of an instance:
 * `furrowTarget` the rectangle in 0..1 of the atlas (x0, y0, x1, y1), `furrowTexels` the same in texels of the area,
 * `furrowSource` the area's slice and channel, `furrowActivation` its activation in the channel of its layer.
 */
export class Quads {
  readonly mesh: Mesh<InstancedBufferGeometry, Material>
  readonly #cells: CellGrid
  #data = new Float32Array(16 * STRIDE)
  #buffer!: InstancedInterleavedBuffer
  #count = 0

  constructor(cells: CellGrid, material: Material) {
    this.#cells = cells
    this.mesh = new Mesh(new InstancedBufferGeometry(), material)
    this.mesh.frustumCulled = false
    this.mesh.matrixAutoUpdate = false
    this.#bind()
  }

  begin(): void {
    this.#count = 0
  }

  /** Adds the rectangle of one area in the cell at `column` and `row`. */
  put(column: number, row: number, { bounds, slice, channel, layer }: AreaSlot, activation: number): void {
    if ((this.#count + 1) * STRIDE > this.#data.length) this.#grow()
    const { width, height, grid } = this.#cells
    const { x0, y0, x1, y1 } = bounds
    const data = this.#data
    const at = STRIDE * this.#count++
    data[at] = (column + x0 / width) / grid.columns
    data[at + 1] = (row + y0 / height) / grid.rows
    data[at + 2] = (column + x1 / width) / grid.columns
    data[at + 3] = (row + y1 / height) / grid.rows
    data[at + 4] = x0
    data[at + 5] = y0
    data[at + 6] = x1
    data[at + 7] = y1
    data[at + 8] = slice
    data[at + 9] = channel
    for (let i = 0; i < MAX_LAYERS; i++) data[at + 12 + i] = i === layer ? activation : 0
  }

  end(): void {
    this.mesh.visible = this.#count > 0
    this.mesh.geometry.instanceCount = this.#count
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

  /** Buffers on the GPU do not grow, so a larger one comes with a geometry of its own. */
  #bind(): void {
    this.mesh.geometry.dispose()
    const geometry = new InstancedBufferGeometry()
    geometry.setAttribute(
      'position',
      new BufferAttribute(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0), 3),
    )
    geometry.setIndex([0, 1, 2, 2, 1, 3])
    this.#buffer = new InstancedInterleavedBuffer(this.#data, STRIDE)
    this.#buffer.setUsage(DynamicDrawUsage)
    for (const [i, name] of ATTRIBUTES.entries()) {
      geometry.setAttribute(name, new InterleavedBufferAttribute(this.#buffer, 4, 4 * i))
    }
    this.mesh.geometry = geometry
  }
}
