import type { Mesh } from 'three'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import { checkIsMesh } from '../mesh/check-mesh.ts'
import { instancesOf } from '../mesh/instances.ts'
import type { WrinklesOptions } from '../options.ts'
import { WrinklesBase } from '../wrinkles-base.ts'
import { checkBatch } from './influence/influence.ts'
import { WEBGPU } from './parts.ts'

/** Wrinkles on one mesh for `WebGPURenderer`, on WebGPU and on its WebGL 2 backend. */
export class Wrinkles extends WrinklesBase {
  /**
   * @param mesh needs UVs and normals and a lit material of its own: a node material or a plain one; each
   *   instance of an `InstancedMesh` or `BatchedMesh` wrinkles independently.
   * @param source a set, copied: later changes to it have no effect, use `addArea`, `removeArea`, `updateArea` and
   *   `updateLayer`. Or the wrinkles of another mesh, which are then shown here too, at rest, from the same textures and by the same
   *   drivers.
   * @throws FurrowError when the mesh, its material or the set does not fit, or three.js is too old or lacks what
   *   is needed; the mesh is then unchanged.
   */
  constructor(mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase, options: WrinklesOptions = {}) {
    super(WEBGPU, withBatchChecked(mesh), source, options)
  }
}

/** @throws FurrowError when it is not a mesh, or three.js lacks what is needed for a `BatchedMesh`. */
function withBatchChecked(mesh: Mesh): Mesh {
  checkIsMesh(mesh, 'Wrinkles')
  if (instancesOf(mesh) === 'batched') checkBatch(mesh)
  return mesh
}
