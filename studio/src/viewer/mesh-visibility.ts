import { effect, type ReadonlySignal, signal } from '@preact/signals'
import type { Mesh } from 'three'
import type { Viewer } from './viewer.ts'

/** Stores which meshes of the avatar the stage hides, such as hair over the forehead. The document does not contain this state. */
export class MeshVisibility {
  readonly #hidden = signal<ReadonlySet<Mesh>>(new Set())

  /** @param wake requests the next frame. */
  constructor(viewer: ReadonlySignal<Viewer | null>, wake: () => void) {
    effect(() => {
      const hidden = this.#hidden.value
      for (const mesh of viewer.value?.meshes ?? []) {
        // Layers hide only this mesh. `visible` would also hide its children, and looks of the face change it.
        if (hidden.has(mesh)) mesh.layers.disable(0)
        else mesh.layers.enable(0)
      }
      wake()
    })
  }

  get hidden(): ReadonlySignal<ReadonlySet<Mesh>> {
    return this.#hidden
  }

  /** Hides the meshes with these indices in `Viewer.meshes`, and shows the others. Ignores indices without a mesh. */
  restore({ meshes }: Viewer, indices: readonly number[]): void {
    this.#hidden.value = new Set(indices.flatMap((i) => meshes[i] ?? []))
  }

  toggle(mesh: Mesh): void {
    const hidden = new Set(this.#hidden.peek())
    if (!hidden.delete(mesh)) hidden.add(mesh)
    this.#hidden.value = hidden
  }
}
