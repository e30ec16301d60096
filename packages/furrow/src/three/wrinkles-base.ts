import type { Material, Mesh } from 'three'
import type { ArraySlice, WrinkleSet } from '../core/types.ts'
import { groupOf, WrinkleFaces } from '../runtime/wrinkle-faces.ts'
import { checkSource } from './check-source.ts'
import type { RendererParts } from './material/renderer-parts.ts'
import { registerWrinkles } from './mesh-wrinkles.ts'
import type { ReliefMode, WrinkleMode, WrinklesOptions } from './options.ts'
import type { AnyRenderer } from './renderer.ts'
import { statisticsOf, type WrinkleStatistics } from './statistics.ts'
import { WrinkledMesh } from './wrinkled-mesh.ts'

/** Returns the internals of `Wrinkles`. */
export function meshOf(wrinkles: WrinklesBase): WrinkledMesh {
  // The constructor below creates no other group.
  return groupOf(wrinkles) as WrinkledMesh
}

/**
 * Wrinkles on one mesh, or on each instance of an `InstancedMesh` or `BatchedMesh`. Base class of `Wrinkles` for both renderers. The
 * material is patched, not replaced: morphs, skinning, shadows, environment and `normalScale` keep working, and `dispose` restores it.
 */
export abstract class WrinklesBase extends WrinkleFaces {
  /** @throws FurrowError if the mesh, its material or the set is invalid; the mesh is then unchanged. */
  protected constructor(
    renderer: RendererParts,
    mesh: Mesh,
    source: WrinkleSet<ArraySlice> | WrinklesBase,
    options?: WrinklesOptions,
  ) {
    const checked = source instanceof WrinklesBase ? meshOf(source) : checkSource(source)
    super(new WrinkledMesh(renderer, mesh, checked, options))
    this.onDispose(registerWrinkles(mesh, this))
  }

  /** Mesh whose blendshapes, skeleton and surface the drivers read. */
  get mesh(): Mesh {
    return meshOf(this).mesh
  }

  /** The meshes that show these wrinkles: `mesh`, then those given to `addMesh`. */
  get meshes(): readonly Mesh[] {
    return [...meshOf(this).meshes]
  }

  /** Shading mode. */
  get mode(): WrinkleMode {
    return meshOf(this).mode
  }

  /**
   * Changes the shading mode and recompiles the material. `composed` shows normals only, and ignores `fadeBelow`.
   *
   * @throws FurrowError if the mode is unsupported here; the mode then stays unchanged. The mode `paper` needs one layer, a material that
   *   can be patched, and readable maps of one size. The modes `paper` and `composed` do not support instances.
   */
  set mode(mode: WrinkleMode) {
    meshOf(this).mode = mode
  }

  /** When the layers' heights displace the surface. */
  get relief(): ReliefMode {
    return meshOf(this).relief.mode
  }

  /**
   * Changes when the layers' heights displace the surface. On first use, triangles under areas are split in time slices, and the face has no
   * relief until that is done. Meshes that do not support relief stay unchanged; `on` then warns once.
   *
   * @throws FurrowError if the value is unknown.
   */
  set relief(mode: ReliefMode) {
    meshOf(this).relief.mode = mode
  }

  /** Prepares relief now instead of on first use. Resolves when relief can be drawn, or if there are no heights. */
  async reliefReady(): Promise<void> {
    await meshOf(this).relief.ready()
  }

  /**
   * Updates inputs, drivers and activations now. Only needed to read activations without drawing: every rendered frame updates them.
   *
   * @param renderer draws the influence maps too. If null, inputs measured on the GPU keep their last value.
   */
  update(renderer: AnyRenderer | null = null): void {
    meshOf(this).update(renderer)
  }

  /** Measures what the wrinkles cost. For panels and debugging: it allocates. */
  get statistics(): WrinkleStatistics {
    return statisticsOf(meshOf(this))
  }

  /**
   * Creates a material that shows influence on the moving mesh as gray: black = 0, white = 1. Dispose of it after use. Create a new one
   * after adding or removing areas.
   *
   * @param area area name or names, to show their weights regardless of activation. Default: the current influence.
   * @throws FurrowError if an area is unknown.
   */
  createInfluenceMaterial(area?: string | readonly string[]): Material {
    return meshOf(this).createInfluenceMaterial(area)
  }

  /**
   * Adds another mesh with the same material, e.g. a second primitive of the face. All meshes show the same wrinkles, in any draw order.
   */
  addMesh(mesh: Mesh): void {
    meshOf(this).addMesh(mesh)
    this.onDispose(registerWrinkles(mesh, this))
  }

  /**
   * Clones the material without its wrinkles, for another mesh that gets its own wrinkles. If the mesh has several materials, returns an
   * array in which only the wrinkled material is cloned.
   */
  cloneMaterial(): Material | Material[] {
    return meshOf(this).cloneMaterial()
  }
}
