import type { Mesh } from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import { wrongArgument } from '../../core/argument.ts'
import { checkNormals } from '../mesh/check-mesh.ts'
import { RecomputedNormals as NormalsOnProcessor } from '../RecomputedNormals.ts'
import { canCompute } from './compute/buffers.ts'
import { ComputedNormals } from './compute/computed-normals.ts'

/**
 * Recomputes a mesh's normals and tangents as its blendshapes deform it, as `RecomputedNormals` of furrow/three does, in compute
 * passes: nothing is read back. The normals are those of the mesh before skinning, which three.js applies to them afterwards. On the
 * WebGL 2 backend of `WebGPURenderer` the processor computes them. The first `update` replaces the mesh's geometry by one
 * that shares its buffers.
 */
export class RecomputedNormals {
  readonly #mesh: Mesh
  #normals: ComputedNormals | NormalsOnProcessor | null = null

  /**
   * @param mesh with normals; without blendshapes `update` changes nothing.
   * @throws FurrowError when it is not a mesh, or has no normals.
   */
  constructor(mesh: Mesh) {
    checkNormals(mesh, 'RecomputedNormals')
    this.#mesh = mesh
  }

  /**
   * Updates normals and tangents to the mesh's blendshapes; call it in every frame, before the mesh is drawn. It does nothing while no
   * weight changes, and before the renderer is initialised.
   *
   * @throws FurrowError when it is not a WebGPURenderer.
   */
  update(renderer: WebGPURenderer): void {
    if (typeof renderer?.hasInitialized !== 'function') {
      throw wrongArgument(
        'RecomputedNormals of furrow/webgpu',
        'a renderer',
        (renderer as object | null)?.constructor.name,
        'WebGPURenderer',
      )
    }
    if (!renderer.hasInitialized()) return
    this.#normals ??= canCompute(renderer)
      ? new ComputedNormals(this.#mesh)
      : new NormalsOnProcessor(this.#mesh)
    this.#normals.update(renderer)
  }

  /** Restores the mesh's geometry. */
  dispose(): void {
    this.#normals?.dispose()
    this.#normals = null
  }
}
