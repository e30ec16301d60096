import type { Mesh } from 'three'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import { checkIsMesh } from '../mesh/check-mesh.ts'
import { instancesOf } from '../mesh/instances.ts'
import type { WrinklesOptions } from '../options.ts'
import { WrinklesBase } from '../wrinkles-base.ts'
import { checkBatch } from './influence/influence.ts'
import { WEBGPU } from './parts.ts'

/** Wrinkles on one mesh for `WebGPURenderer`, with its WebGPU or WebGL 2 backend. */
export class Wrinkles extends WrinklesBase {
  /**
   * @param mesh mesh with UVs, normals, and a lit material (node material or not) that no other mesh uses. Each instance of an
   *   `InstancedMesh` or `BatchedMesh` wrinkles independently.
   * @param source wrinkle set, copied: edit it later with `addArea`, `removeArea`, `updateArea` and `updateLayer`. Or the wrinkles of
   *   another mesh, to share their textures and drivers; activations start at rest.
   * @throws FurrowError if the mesh, its material or the set is invalid, or the three.js release is unsupported; the mesh is then
   *   unchanged.
   */
  constructor(mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase, options: WrinklesOptions = {}) {
    super(WEBGPU, withBatchChecked(mesh), source, options)
  }
}

/** @throws FurrowError if the value is not a mesh, or three.js lacks an internal required for a `BatchedMesh`. */
function withBatchChecked(mesh: Mesh): Mesh {
  checkIsMesh(mesh, 'Wrinkles')
  if (instancesOf(mesh) === 'batched') checkBatch(mesh)
  return mesh
}
