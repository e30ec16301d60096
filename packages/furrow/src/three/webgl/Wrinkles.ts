import type { Mesh } from 'three'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import type { WrinklesOptions } from '../options.ts'
import { WrinklesBase } from '../wrinkles-base.ts'
import { WEBGL } from './parts.ts'

/** Wrinkles on one mesh for `WebGLRenderer`. */
export class Wrinkles extends WrinklesBase {
  /**
   * @param mesh mesh with UVs, normals, and a lit material that no other mesh uses. Each instance of an `InstancedMesh` or `BatchedMesh`
   *   wrinkles independently.
   * @param source wrinkle set, copied: edit it later with `addArea`, `removeArea`, `updateArea` and `updateLayer`. Or the wrinkles of
   *   another mesh, to share their textures and drivers; activations start at rest.
   * @throws FurrowError if the mesh, its material or the set is invalid; the mesh is then unchanged.
   */
  constructor(mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase, options: WrinklesOptions = {}) {
    super(WEBGL, mesh, source, options)
  }
}
