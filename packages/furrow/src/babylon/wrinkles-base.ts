import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { Scene } from '@babylonjs/core/scene.js'
import { groupOf, WrinkleFaces } from '../runtime/wrinkle-faces.ts'
import type { WrinkleMode } from './options.ts'
import type { WrinkledMesh } from './wrinkled-mesh.ts'

const wrinklesByMesh = new WeakMap<WrinkledMesh, WrinklesBase>()

/** Returns the internals of `Wrinkles`. */
export function meshOf(wrinkles: WrinklesBase): WrinkledMesh {
  // The constructor below accepts no other group.
  return groupOf(wrinkles) as WrinkledMesh
}

/** Returns the public object for the internals of a face. */
export function wrinklesFor(mesh: WrinkledMesh): WrinklesBase {
  return wrinklesByMesh.get(mesh) ?? new WrinklesBase(mesh)
}

/**
 * Wrinkles on one mesh, on one instance, or on each thin instance. `registerWrinkleMaps` adds them to loaded files. Base class of
 * `Wrinkles`. The material is patched, not replaced, and `dispose` restores it. Copies of the mesh by `clone`, `createInstance` or
 * `instantiateModelsToScene` get their own wrinkles before they are first drawn.
 */
export class WrinklesBase extends WrinkleFaces {
  constructor(mesh: WrinkledMesh) {
    super(mesh)
    wrinklesByMesh.set(mesh, this)
  }

  /** Mesh whose morph targets, skeleton and surface the drivers read. */
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
   * @throws FurrowError if the mode is unsupported, or the material shows another set; the mode then stays unchanged.
   */
  set mode(mode: WrinkleMode) {
    meshOf(this).mode = mode
  }

  /**
   * Adds another mesh that shows the same wrinkles, e.g. a second primitive of the face.
   *
   * @throws FurrowError if its material is unsupported, or shows another set.
   */
  addMesh(mesh: AbstractMesh): void {
    meshOf(this).addMesh(mesh)
  }

  /**
   * Updates inputs, drivers and activations now. Only needed to read activations without drawing: every rendered frame updates them.
   *
   * @param scene scene of the mesh, to draw the influence maps too.
   */
  update(scene: Scene | null = null): void {
    meshOf(this).update(scene)
  }
}
