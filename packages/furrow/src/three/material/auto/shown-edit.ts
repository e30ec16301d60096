import type { Edit, Patch } from '../patch.ts'
import type { WrinkleMaterial } from '../wrinkle-material.ts'

/** The edit that a material is drawn by. */
export class ShownEdit {
  readonly #material: WrinkleMaterial
  readonly #patch: Patch
  #edit: Edit | null

  constructor(material: WrinkleMaterial, patch: Patch) {
    this.#material = material
    this.#patch = patch
    this.#edit = patch.edit
  }

  /** @param edit null for the material's own program. */
  show(edit: Edit | null): void {
    if (edit === this.#edit) return
    this.#edit = edit
    this.#patch.setEdit(edit)
    this.#material.needsUpdate = true
  }

  /** Runs a function while another edit is in effect. It may draw, and so show others: `WebGPURenderer` does while it compiles. */
  during<T>(edit: Edit | null, run: () => T): T {
    this.#patch.setEdit(edit)
    const result = run()
    this.#patch.setEdit(this.#edit)
    return result
  }
}
