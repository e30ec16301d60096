import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { ArraySlice, WrinkleSet } from '../core/types.ts'
import { checkSource } from './check-source.ts'
import type { WrinklesOptions } from './options.ts'
import { WrinkledMesh } from './wrinkled-mesh.ts'
import { meshOf, WrinklesBase } from './wrinkles-base.ts'

/** Wrinkles on one mesh, for a wrinkle set that is not in a file. */
export class Wrinkles extends WrinklesBase {
  /**
   * @param mesh needs UVs whose v points down, as in glTF, normals, and a `PBRMaterial` or `StandardMaterial`; each of its thin
   *   instances wrinkles independently.
   * @param source a set, copied. Or the wrinkles of another mesh, which are then shown here too, at rest, from the same textures and by the same drivers; or
   *   those of the mesh itself, which are replaced, as after a change of its thin instances.
   * @throws FurrowError when the mesh, its material or the set does not fit; the mesh is then unchanged.
   */
  constructor(
    mesh: AbstractMesh,
    source: WrinkleSet<ArraySlice> | WrinklesBase,
    options: WrinklesOptions = {},
  ) {
    const own = source instanceof WrinklesBase ? meshOf(source) : checkSource(source)
    super(new WrinkledMesh(mesh, own, options))
  }
}
