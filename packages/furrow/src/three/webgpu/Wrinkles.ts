import type { Mesh } from 'three'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import { checkIsMesh } from '../mesh/check-mesh.ts'
import { instancesOf } from '../mesh/instances.ts'
import type { WrinklesOptions } from '../options.ts'
import { WrinklesBase } from '../wrinkles-base.ts'
import { checkBatch } from './influence/influence.ts'
import { WEBGPU } from './parts.ts'

/** Shows a wrinkle set on a mesh that `WebGPURenderer` draws, with its WebGPU or WebGL 2 backend. */
export class Wrinkles extends WrinklesBase {
  /**
   * @param mesh mesh with UVs, normals, and a lit material (node material or not) that no other mesh uses. Each instance of an
   *   `InstancedMesh` or `BatchedMesh` has separate activations.
   * @param source wrinkle set, or the wrinkles of another mesh. A set is copied; use `addArea`, `removeArea`, `updateArea` and `updateLayer`
   *   to change it later. If wrinkles of another mesh are given, both meshes share textures and drivers, but have separate activations.
   * @throws FurrowError if the mesh, its material or the set is invalid, or the three.js release is unsupported; the mesh is then
   *   unchanged.
   */
  constructor(mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase, options: WrinklesOptions = {}) {
    super(WEBGPU, withBatchChecked(mesh), source, options)
  }
}

/** @throws FurrowError if the value is not a mesh, or if three.js lacks an internal property that a `BatchedMesh` needs. */
function withBatchChecked(mesh: Mesh): Mesh {
  checkIsMesh(mesh, 'Wrinkles')
  if (instancesOf(mesh) === 'batched') checkBatch(mesh)
  return mesh
}
