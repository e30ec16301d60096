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

export function meshOf(wrinkles: WrinklesBase): WrinkledMesh {
  // `WrinklesBase` always passes a `WrinkledMesh` to its base class.
  return groupOf(wrinkles) as WrinkledMesh
}

/**
 * Wrinkles on one mesh, or on each instance of an `InstancedMesh` or `BatchedMesh`. Base class of `Wrinkles` for both renderers. Patches the
 * material instead of replacing it, so morphs, skinning, shadows, environment and `normalScale` keep working. `dispose` removes the patch.
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

  /** Mesh whose blendshapes, skeleton and deformed surface the drivers read. */
  get mesh(): Mesh {
    return meshOf(this).mesh
  }

  /** Meshes that show these wrinkles: `mesh`, then the meshes given to `addMesh`. */
  get meshes(): readonly Mesh[] {
    return [...meshOf(this).meshes]
  }

  /** Shading mode. */
  get mode(): WrinkleMode {
    return meshOf(this).mode
  }

  /**
   * Changes the shading mode and recompiles the material. `composed` uses only the normal maps of the layers, and ignores `fadeBelow`.
   *
   * @throws FurrowError if the mode is unsupported for the mesh or material; the mode then stays unchanged. The mode `paper` needs one layer,
   *   a material that can be patched, and maps of equal size whose pixels JavaScript can read (e.g. PNG or WebP, not KTX2). The modes `paper`
   *   and `composed` do not support instances.
   */
  set mode(mode: WrinkleMode) {
    meshOf(this).mode = mode
  }

  /** Setting that determines when height maps displace the surface, see `ReliefMode`. */
  get relief(): ReliefMode {
    return meshOf(this).relief.mode
  }

  /**
   * Changes when height maps displace the surface (relief). On first use, triangles under areas are split over several frames, and the face
   * has no relief until all are split. If a mesh of the face does not support relief, the whole face has none, and the mode `on` logs a warning.
   *
   * @throws FurrowError if the value is unknown.
   */
  set relief(mode: ReliefMode) {
    meshOf(this).relief.mode = mode
  }

  /** Prepares relief now instead of on first use. Resolves when relief can be drawn, or if the layers have no height maps. */
  async reliefReady(): Promise<void> {
    await meshOf(this).relief.ready()
  }

  /**
   * Updates inputs, drivers and activations now. Only needed to read activations without drawing, because every rendered frame updates them.
   *
   * @param renderer if given, also draws the influence maps. If null, inputs measured on the GPU keep their last value.
   */
  update(renderer: AnyRenderer | null = null): void {
    meshOf(this).update(renderer)
  }

  /** Measures the cost of the wrinkles, for panels and debugging. Allocates. */
  get statistics(): WrinkleStatistics {
    return statisticsOf(meshOf(this))
  }

  /**
   * Creates a material that shows the influence map on the mesh in gray: black = 0, white = 1. Dispose of the material after use. Create a new
   * material after adding or removing areas.
   *
   * @param area name or names of areas. The material then shows the weights of these areas instead, regardless of activation.
   * @throws FurrowError if an area is unknown.
   */
  createInfluenceMaterial(area?: string | readonly string[]): Material {
    return meshOf(this).createInfluenceMaterial(area)
  }

  /**
   * Adds another mesh with the same material, e.g. a second primitive of the face. All meshes show the same wrinkles.
   */
  addMesh(mesh: Mesh): void {
    meshOf(this).addMesh(mesh)
    this.onDispose(registerWrinkles(mesh, this))
  }

  /**
   * Clones the material without its wrinkles, for another mesh that gets its own wrinkles. If the mesh has several materials, returns all of
   * them in an array, and clones only the material with wrinkles.
   */
  cloneMaterial(): Material | Material[] {
    return meshOf(this).cloneMaterial()
  }
}
