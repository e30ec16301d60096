import { DataTexture, FloatType, NearestFilter, RGBAFormat } from 'three'
import { MAX_AREAS, MAX_LAYERS } from '../../core/limits.ts'
import type { Activations } from '../../runtime/activations.ts'
import type { AreaArray } from '../atlas/area-array.ts'

/** One column per channel of the largest area array. */
const COLUMNS = 4 * MAX_AREAS

/**
 * Activations as a texture, for shaders that loop over all areas as the paper does.
 *
 * Each area has a column, `slice * channels + channel`, where `slice` and `channel` locate its weights. Row 0 holds areas that combine by
 * `sum`, row 1 those that combine by `max`. The activation is in the texel's channel with the index of the area's layer; other channels are
 * 0. One loop therefore computes all layers, and shader programs do not depend on the number of areas or their layers.
 */
export class ActivationTable {
  readonly texture: DataTexture
  /** Uniform: number of columns in use. */
  readonly count = { value: 0 }
  readonly #table = new Float32Array(COLUMNS * 2 * MAX_LAYERS)
  #version = -1

  constructor() {
    this.texture = new DataTexture(this.#table, COLUMNS, 2, RGBAFormat, FloatType)
    this.texture.minFilter = NearestFilter
    this.texture.magFilter = NearestFilter
  }

  /**
   * Writes the activations of all areas if their version has changed.
   *
   * @param activations values (0..1) in the order of the areas.
   */
  update({ slots, channels }: AreaArray, { version, values }: Pick<Activations, 'version' | 'values'>): void {
    if (version === this.#version) return
    this.#version = version
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
