import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { Scene } from '@babylonjs/core/scene.js'
import { groupOf, WrinkleFaces } from '../runtime/wrinkle-faces.ts'
import type { WrinkleMode } from './options.ts'
import type { WrinkledMesh } from './wrinkled-mesh.ts'

const wrinklesByMesh = new WeakMap<WrinkledMesh, WrinklesBase>()

/** Returns the internal state of `Wrinkles`. */
export function meshOf(wrinkles: WrinklesBase): WrinkledMesh {
  // The constructor of `WrinklesBase` accepts no other type.
  return groupOf(wrinkles) as WrinkledMesh
}

/** Returns the `WrinklesBase` object of a `WrinkledMesh`, or creates it. */
export function wrinklesFor(mesh: WrinkledMesh): WrinklesBase {
  return wrinklesByMesh.get(mesh) ?? new WrinklesBase(mesh)
}

/**
 * Wrinkles on one mesh, on one instance, or on each thin instance of a mesh. Base class of `Wrinkles`. `registerWrinkleMaps` creates
 * objects of this class for loaded files. The material of the mesh is patched, and `dispose` restores it. If `clone`, `createInstance`
 * or `instantiateModelsToScene` copies the mesh, the copy gets separate wrinkles before it is first drawn.
 */
export class WrinklesBase extends WrinkleFaces {
  constructor(mesh: WrinkledMesh) {
    super(mesh)
    wrinklesByMesh.set(mesh, this)
  }

  /** Mesh from which drivers read morph targets, joints and tension. */
  get mesh(): AbstractMesh {
    return meshOf(this).mesh
  }

  /** Shading mode. */
  get mode(): WrinkleMode {
    return meshOf(this).mode
  }

  /**
   * Changes the shading mode.
   *
   * @throws FurrowError if the mode is unsupported, or if the material draws another set. The mode then stays unchanged.
   */
  set mode(mode: WrinkleMode) {
    meshOf(this).mode = mode
  }

  /**
   * Draws the same wrinkles on another mesh, e.g. on a second primitive of the face.
   *
   * @throws FurrowError if the material of the mesh is unsupported, or if it draws another set.
   */
  addMesh(mesh: AbstractMesh): void {
    meshOf(this).addMesh(mesh)
  }

  /**
   * Updates inputs, drivers and activations now. Every rendered frame does this, so calling it is only needed to read activations without
   * rendering.
   *
   * @param scene scene of the mesh. If it is given, influence maps are drawn too.
   */
  update(scene: Scene | null = null): void {
    meshOf(this).update(scene)
  }
}
