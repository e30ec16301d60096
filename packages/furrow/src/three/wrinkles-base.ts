import type { Material, Mesh } from 'three'
import type { ArraySlice, WrinkleSet } from '../core/types.ts'
import { groupOf, WrinkleFaces } from '../runtime/wrinkle-faces.ts'
import { noteAdded } from './added-to.ts'
import { checkSource } from './check-source.ts'
import type { RendererParts } from './material/renderer-parts.ts'
import type { ReliefMode, WrinkleMode, WrinklesOptions } from './options.ts'
import type { AnyRenderer } from './renderer.ts'
import { WrinkledMesh } from './wrinkled-mesh.ts'

/** The mesh behind wrinkles, for code of the library. */
export function meshOf(wrinkles: WrinklesBase): WrinkledMesh {
  // The constructor below accepts no other.
  return groupOf(wrinkles) as WrinkledMesh
}

/**
 * Wrinkles on one mesh, or on each instance of an `InstancedMesh` or `BatchedMesh`: the base of both renderers' `Wrinkles`. The
 * material remains the user's: morphs, skinning, shadows, environment and `normalScale` keep working, and `dispose` restores it.
 */
export abstract class WrinklesBase extends WrinkleFaces {
  /** @throws FurrowError when the mesh, its material or the set does not fit; the mesh is then unchanged. */
  protected constructor(
    renderer: RendererParts,
    mesh: Mesh,
    source: WrinkleSet<ArraySlice> | WrinklesBase,
    options?: WrinklesOptions,
  ) {
    const own = source instanceof WrinklesBase ? meshOf(source) : checkSource(source)
    super(new WrinkledMesh(renderer, mesh, own, options))
    this.onDispose(noteAdded(mesh, this))
  }

  /** The mesh that drives: its blendshapes, skeleton and surface are measured. */
  get mesh(): Mesh {
    return meshOf(this).mesh
  }

  /** How wrinkles are shown. */
  get mode(): WrinkleMode {
    return meshOf(this).mode
  }

  /**
   * Changes how wrinkles are shown; the material's program is recompiled. The composed mode shows normals only, and does not fade.
   *
   * @throws FurrowError when the mode is not possible: `paper` with more than one layer, or with maps of the material that
   *   cannot be read or differ in size; `paper` and `composed` for instances; `paper` for a material that cannot be patched. The mode then
   *   stays as it was.
   */
  set mode(mode: WrinkleMode) {
    meshOf(this).mode = mode
  }

  /** Whether the layers' heights move the surface. */
  get relief(): ReliefMode {
    return meshOf(this).relief.mode
  }

  /**
   * Changes whether the layers' heights move the surface. Triangles under areas are split when that is first wanted, in slices: the page
   * goes on, and shows the face without relief until then. Meshes that cannot have relief stay as they are; `on` warns of it, once.
   *
   * @throws FurrowError when there is no such value.
   */
  set relief(mode: ReliefMode) {
    meshOf(this).relief.mode = mode
  }

  /** Splits the triangles for relief now, where there are heights; fulfilled when it can be drawn. */
  async reliefReady(): Promise<void> {
    await meshOf(this).relief.ready()
  }

  /**
   * Updates inputs, drivers and activations now. Every frame does so before it is drawn; this is for tests, and for pages that read
   * activations without drawing.
   *
   * @param renderer also draws the influence maps. Without one, inputs that only a renderer can measure keep their last value.
   */
  update(renderer: AnyRenderer | null = null): void {
    meshOf(this).update(renderer)
  }

  /**
   * Creates a material that shows influence as gray on the moving mesh, black = none, white = 1: the current influence, or the weights
   * of some areas, whatever their activations. Dispose of it after use, and create it again after areas were added or removed.
   *
   * @param area name or names; by default, the current influence.
   *
   * @throws FurrowError when no area has that name.
   */
  createInfluenceMaterial(area?: string | readonly string[]): Material {
    return meshOf(this).createInfluenceMaterial(area)
  }

  /**
   * Adds another mesh with the same material, such as a second primitive of the face. It shows the same wrinkles, whichever mesh is
   * drawn first.
   */
  addMesh(mesh: Mesh): void {
    meshOf(this).addMesh(mesh)
    this.onDispose(noteAdded(mesh, this))
  }

  /**
   * Copies the material without its wrinkles, for another mesh with wrinkles of its own; of a mesh with several materials a list, in which
   * the others are the same.
   */
  cloneMaterial(): Material | Material[] {
    return meshOf(this).cloneMaterial()
  }
}
