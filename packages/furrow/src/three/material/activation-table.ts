import { DataTexture, FloatType, NearestFilter, RGBAFormat } from 'three'
import { MAX_AREAS, MAX_LAYERS } from '../../core/limits.ts'
import type { AreaArray } from '../atlas/area-array.ts'

/** One column per channel of a slice: as many as there could be. */
const COLUMNS = 4 * MAX_AREAS

/**
 * Activations as a texture, for shaders that loop over all areas as the paper does.
 *
 * Column `slice * channels + channel` belongs to the area whose weights lie there. Row 0 serves areas that add up, row 1 those that
 * combine by `max`; the activation stands in the channel of the area's layer, all else is 0. So one loop sums
 * every layer at once, and neither the number of areas nor the layer of an area is part of a shader program.
 */
export class ActivationTable {
  readonly texture: DataTexture
  /** Columns in use; a uniform. */
  readonly count = { value: 0 }
  readonly #table = new Float32Array(COLUMNS * 2 * MAX_LAYERS)

  constructor() {
    this.texture = new DataTexture(this.#table, COLUMNS, 2, RGBAFormat, FloatType)
    this.texture.minFilter = NearestFilter
    this.texture.magFilter = NearestFilter
  }

  /** Takes the activations over, in the order of the areas. */
  write({ slots, channels }: AreaArray, values: Float32Array): void {
    this.#table.fill(0)
    this.count.value = 0
    for (let i = 0; i < slots.length; i++) {
      const { slice, channel, combine, layer } = slots[i]
      const column = slice * channels + channel
      this.#table[((combine === 'max' ? COLUMNS : 0) + column) * MAX_LAYERS + layer] = values[i]
      this.count.value = Math.max(this.count.value, column + 1)
    }
    this.texture.needsUpdate = true
  }
}
