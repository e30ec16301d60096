import type { Mesh } from 'three'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import type { WrinklesOptions } from '../options.ts'
import { WrinklesBase } from '../wrinkles-base.ts'
import { WEBGL } from './parts.ts'

/** Wrinkles on one mesh for `WebGLRenderer`. */
export class Wrinkles extends WrinklesBase {
  /**
   * @param mesh needs UVs and normals and a lit material of its own; each instance of an `InstancedMesh`
   *   or `BatchedMesh` wrinkles independently.
   * @param source a set, copied: later changes to it have no effect, use `addArea`, `removeArea`, `updateArea` and
   *   `updateLayer`. Or the wrinkles of another mesh, which are then shown here too, at rest, from the same textures and by the same
   *   drivers.
   * @throws FurrowError when the mesh, its material or the set does not fit; the mesh is then unchanged.
   */
  constructor(mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase, options: WrinklesOptions = {}) {
    super(WEBGL, mesh, source, options)
  }
}
