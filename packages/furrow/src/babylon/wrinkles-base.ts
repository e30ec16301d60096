import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { Scene } from '@babylonjs/core/scene.js'
import { groupOf, WrinkleFaces } from '../runtime/wrinkle-faces.ts'
import type { WrinkleMode } from './options.ts'
import type { WrinkledMesh } from './wrinkled-mesh.ts'

const wrinklesByMesh = new WeakMap<WrinkledMesh, WrinklesBase>()

/** The mesh behind wrinkles, for code of the library. */
export function meshOf(wrinkles: WrinklesBase): WrinkledMesh {
  // The constructor below accepts no other.
  return groupOf(wrinkles) as WrinkledMesh
}

/** The wrinkles of a mesh, as users see them. */
export function wrinklesFor(own: WrinkledMesh): WrinklesBase {
  return wrinklesByMesh.get(own) ?? new WrinklesBase(own)
}

/**
 * Wrinkles on one mesh, on an instance of one, or on each of its thin instances: what `registerWrinkleMaps` adds to loaded files, and the
 * base of `Wrinkles`. The material remains the user's, and `dispose` restores it. Copies of the mesh, by `clone`, `createInstance` or
 * `instantiateModelsToScene`, get wrinkles of their own before they are first drawn.
 */
export class WrinklesBase extends WrinkleFaces {
  constructor(own: WrinkledMesh) {
    super(own)
    wrinklesByMesh.set(own, this)
  }

  /** The mesh that drives: its blendshapes, skeleton and surface are measured. */
  get mesh(): AbstractMesh {
    return meshOf(this).mesh
  }

  /** How wrinkles are shown. */
  get mode(): WrinkleMode {
    return meshOf(this).mode
  }

  /**
   * Changes how wrinkles are shown.
   *
   * @throws FurrowError when Babylon.js has no such mode, or the material shows another set; the mode then stays as it was.
   */
  set mode(mode: WrinkleMode) {
    meshOf(this).mode = mode
  }

  /**
   * Adds another mesh, such as a second primitive of the face. It shows the same wrinkles.
   *
   * @throws FurrowError when its material cannot, or shows those of another set.
   */
  addMesh(mesh: AbstractMesh): void {
    meshOf(this).addMesh(mesh)
  }

  /**
   * Updates inputs, drivers and activations now. Every frame does so before it is drawn; this is for tests, and for pages that read
   * activations without drawing.
   *
   * @param scene that of the mesh, to draw the influence maps too.
   */
  update(scene: Scene | null = null): void {
    meshOf(this).update(scene)
  }
}
