import type { Mesh } from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import { RecomputedNormals as NormalsOnProcessor } from '../RecomputedNormals.ts'
import { canCompute } from './buffers.ts'
import { ComputedNormals } from './computed-normals.ts'

/**
 * Recomputes a mesh's normals and tangents as its blendshapes deform it, as `RecomputedNormals` of furrow/three does, in compute
 * passes: nothing is read back. Three.js turns normals by the skeleton afterwards, so that it is the mesh before skinning whose normals
 * are made. Where `WebGPURenderer` runs on WebGL 2 the processor makes them. From the first `update` on the mesh has a
 * geometry of its own.
 */
export class RecomputedNormals {
  readonly #mesh: Mesh
  #normals: ComputedNormals | NormalsOnProcessor | null = null

  /** @param mesh with normals. Without blendshapes `update` changes nothing. */
  constructor(mesh: Mesh) {
    this.#mesh = mesh
  }

  /**
   * Brings normals and tangents up to date with the mesh's blendshapes; call it in every frame, before the mesh is drawn. While no
   * weight changes it does nothing, nor before the renderer is initialised.
   */
  update(renderer: WebGPURenderer): void {
    if (!renderer.hasInitialized()) return
    this.#normals ??= canCompute(renderer)
      ? new ComputedNormals(this.#mesh)
      : new NormalsOnProcessor(this.#mesh)
    this.#normals.update(renderer)
  }

  /** Gives the mesh its geometry back. */
  dispose(): void {
    this.#normals?.dispose()
    this.#normals = null
  }
}
