import type { Material } from 'three'
import type { Area } from '../../core/types.ts'
import { ActivationTable } from './activation-table.ts'
import type { PatchedMaterial } from './patched-material.ts'
import type { ShaderInputs } from './shader-inputs.ts'

/** The materials that show influence as gray, see `createInfluenceMaterial`. */
export class InfluenceViews {
  readonly #material: PatchedMaterial
  readonly #inputs: ShaderInputs
  /** How many show the current influence. */
  #current = 0

  constructor(material: PatchedMaterial, inputs: ShaderInputs) {
    this.#material = material
    this.#inputs = inputs
  }

  /** Whether one shows the current influence, which needs the map in any mode. */
  get isMapNeeded(): boolean {
    return this.#current > 0
  }

  /** Shows the current influence. */
  showCurrent(): Material {
    const material = this.#material.influenceMaterial(null)
    this.#current++
    material.addEventListener('dispose', () => this.#current--)
    return material
  }

  /** Shows the weights of some areas. */
  showAreas(areas: readonly Area<unknown>[], names: readonly string[]): Material {
    const table = new ActivationTable()
    const values = Float32Array.from(areas, ({ name }) => Number(names.includes(name)))
    table.update(this.#inputs.areas, { version: 0, values })
    const material = this.#material.influenceMaterial(table)
    material.addEventListener('dispose', () => table.texture.dispose())
    return material
  }
}
