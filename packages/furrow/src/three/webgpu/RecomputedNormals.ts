import type { Mesh } from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import { wrongArgument } from '../../core/argument.ts'
import { checkNormals } from '../mesh/check-mesh.ts'
import { RecomputedNormals as CpuNormals } from '../RecomputedNormals.ts'
import { canCompute } from './compute/buffers.ts'
import { ComputedNormals } from './compute/computed-normals.ts'

/**
 * Recomputes a mesh's normals and tangents as its blendshapes deform the mesh. Runs compute passes on the GPU; with the WebGL 2 backend of
 * `WebGPURenderer`, the CPU computes the normals. three.js applies skinning to the recomputed normals. The first `update` replaces the
 * geometry of the mesh. If the GPU computes the normals, the new geometry shares the buffers of the old one.
 */
export class RecomputedNormals {
  readonly #mesh: Mesh
  #normals: ComputedNormals | CpuNormals | null = null

  /**
   * @param mesh mesh with normals. Without blendshapes `update` does nothing.
   * @throws FurrowError if `mesh` is not a mesh, or has no normals.
   */
  constructor(mesh: Mesh) {
    checkNormals(mesh, 'RecomputedNormals')
    this.#mesh = mesh
  }

  /**
   * Updates normals and tangents from the current blendshape weights. Call it once per frame, before the mesh is drawn. Does nothing before the
   * renderer is initialised, or while no weight changes.
   *
   * @throws FurrowError if `renderer` is not a WebGPURenderer.
   */
  update(renderer: WebGPURenderer): void {
    if (typeof renderer?.hasInitialized !== 'function') {
      throw wrongArgument(
        'RecomputedNormals of furrow/webgpu',
        'renderer',
        (renderer as object | null)?.constructor.name,
        'WebGPURenderer',
      )
    }
    if (!renderer.hasInitialized()) return
    this.#normals ??= canCompute(renderer) ? new ComputedNormals(this.#mesh) : new CpuNormals(this.#mesh)
    this.#normals.update(renderer)
  }

  /** Restores the mesh's original geometry. */
  dispose(): void {
    this.#normals?.dispose()
    this.#normals = null
  }
}
