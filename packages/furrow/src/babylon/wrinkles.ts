import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { ArraySlice, WrinkleSet } from '../core/types.ts'
import { checkSource } from './check-source.ts'
import type { WrinklesOptions } from './options.ts'
import { WrinkledMesh } from './wrinkled-mesh.ts'
import { meshOf, WrinklesBase } from './wrinkles-base.ts'

/** Wrinkles on one mesh, created from a wrinkle set in memory. */
export class Wrinkles extends WrinklesBase {
  /**
   * @param mesh mesh with normals, UVs (v pointing down, as in glTF), and a `PBRMaterial` or `StandardMaterial`. Thin instances of the mesh
   *   have separate activations.
   * @param source wrinkle set, which is copied, or existing wrinkles, whose textures and drivers are shared. If the number of thin
   *   instances changes, create the wrinkles again and pass the mesh's existing wrinkles here.
   * @throws FurrowError if the mesh, its material or the set is invalid. The mesh is then unchanged.
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
