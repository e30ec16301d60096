import type { Mesh } from 'three'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import type { WrinklesOptions } from '../options.ts'
import { WrinklesBase } from '../wrinkles-base.ts'
import { WEBGL } from './parts.ts'

/** Shows a wrinkle set on a mesh that `WebGLRenderer` draws. */
export class Wrinkles extends WrinklesBase {
  /**
   * @param mesh mesh with UVs, normals, and a lit material that no other mesh uses. Each instance of an `InstancedMesh` or `BatchedMesh` has
   *   separate activations.
   * @param source wrinkle set, or the wrinkles of another mesh. A set is copied; use `addArea`, `removeArea`, `updateArea` and `updateLayer`
   *   to change it later. If wrinkles of another mesh are given, both meshes share textures and drivers, but have separate activations.
   * @throws FurrowError if the mesh, its material or the set is invalid; the mesh is then unchanged.
   */
  constructor(mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase, options: WrinklesOptions = {}) {
    super(WEBGL, mesh, source, options)
  }
}
