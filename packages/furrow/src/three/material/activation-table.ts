import { DataTexture, FloatType, NearestFilter, RGBAFormat } from 'three'
import { MAX_AREAS, MAX_LAYERS } from '../../core/limits.ts'
import type { Activations } from '../../runtime/activations.ts'
import type { AreaArray } from '../atlas/area-array.ts'

/** Number of columns: one per channel of the largest texture array of areas. */
const COLUMNS = 4 * MAX_AREAS

/**
 * Texture with the activations of all areas, for shaders that loop over areas in every pixel. An area is a group of wrinkles with weights in UV
 * space, and its activation (0..1) is the current strength of these wrinkles. The mode `paper` has such a shader.
 *
 * The texel of an area is in column `slice * channels + channel`, where `slice` and `channel` locate its weights in the texture array. The
 * texel is in row 0 if the area combines by `sum`, in row 1 if it combines by `max`. The channels of a texel are the layers: the channel of
 * the area's layer holds the activation, and the other channels are 0. One loop therefore computes all layers, and no shader depends on the
 * number of areas or on their layers.
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
   * Copies the activations of all areas into the texture if their version has changed.
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
