import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { ArraySlice, WrinkleSet } from '../core/types.ts'
import { checkSource } from './check-source.ts'
import type { WrinklesOptions } from './options.ts'
import { WrinkledMesh } from './wrinkled-mesh.ts'
import { meshOf, WrinklesBase } from './wrinkles-base.ts'

/** Wrinkles on one mesh, from a wrinkle set in memory. */
export class Wrinkles extends WrinklesBase {
  /**
   * @param mesh mesh with normals, UVs (v pointing down, as in glTF), and a `PBRMaterial` or `StandardMaterial`. Each thin instance
   *   wrinkles independently.
   * @param source wrinkle set, copied. Or the wrinkles of another mesh, to share their textures and drivers; activations start at rest.
   *   Pass the mesh's own wrinkles to recreate them after a change of its thin instances.
   * @throws FurrowError if the mesh, its material or the set is invalid; the mesh is then unchanged.
   */
  constructor(
    mesh: AbstractMesh,
    source: WrinkleSet<ArraySlice> | WrinklesBase,
    options: WrinklesOptions = {},
  ) {
    const checked = source instanceof WrinklesBase ? meshOf(source) : checkSource(source)
    super(new WrinkledMesh(mesh, checked, options))
  }
}
