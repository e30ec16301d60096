import type { Camera, Material, Mesh, Scene } from 'three'
import { surfaceOf, withSurface } from '../material/surface.ts'
import { instancesOf } from '../mesh/instances.ts'
import { isReliefMesh } from '../relief/is-relief-mesh.ts'
import type { AnyRenderer } from '../renderer.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'

/**
 * Calls a function before each draw of any mesh that has the given material.
 *
 * @returns a function that stops watching.
 */
export type WatchDraws = (
  material: Material,
  onDraw: (mesh: Mesh, renderer: AnyRenderer, camera: Camera, scene: Scene) => void,
) => () => void

export interface AdoptionParts {
  watch: WatchDraws
  /** Adds wrinkles with the set and textures of `source` to a mesh. Warns and returns undefined if that fails. */
  add(mesh: Mesh, source: WrinklesBase): WrinklesBase | undefined
}

const adoptions = new WeakMap<Material, Adoption>()

/** Returns the wrinkles that a mesh of the page shares with a loaded face, see `Adoption`; undefined if it shares none. */
export function adoptedBy(mesh: Mesh): WrinklesBase | undefined {
  return adoptions.get(surfaceOf(mesh))?.faceOf(mesh)
}

/**
 * Adds wrinkles to meshes that a page creates with the material of a loaded face, as gltfjsx's JSX and drei's `<Clone>` do. Finds such meshes
 * when they are first drawn. If a mesh shares its blendshape weights and skeleton with a loaded mesh, both show the same wrinkles. Otherwise
 * the mesh becomes a separate face, with separate activations and a copy of the material, until it is removed from its parent.
 */
export class Adoption {
  readonly #material: Material
  readonly #meshes: readonly Mesh[]
  readonly #parts: AdoptionParts
  /** The copy of the material for each mesh that is a separate face. If React sets the original material again, the copy is reused. */
  readonly #copies = new WeakMap<Mesh, Material>()
  readonly #unwatch: () => void
  readonly #copyOf: WrinklesBase | undefined
  /** Meshes that the page created and that show the wrinkles of this face. Only used if this face is a clone. */
  readonly #guests = new Set<Mesh>()
  /** Whether one of `#meshes` was drawn. */
  #isShown = false
  #face: WrinklesBase | null = null

  /**
   * Must be created before the material is patched.
   *
   * @param meshes meshes of the face.
   * @param copyOf original face, if this face is a clone.
   */
  constructor(
    material: Material,
    meshes: readonly Mesh[],
    parts: AdoptionParts,
    copyOf: WrinklesBase | undefined,
  ) {
    this.#material = material
    this.#meshes = meshes
    this.#parts = parts
    this.#copyOf = copyOf
    this.#unwatch = parts.watch(material, (mesh, renderer, camera, scene) =>
      this.#onDraw(mesh, renderer, camera, scene),
    )
  }

  /** Adds wrinkles to new meshes until the face is disposed of. */
  begin(face: WrinklesBase): void {
    this.#face = face
    adoptions.set(this.#material, this)
    // drei's `<Clone deep>` clones the material.
    const clone = () => {
      const copy = meshOf(face).cloneSurface()
      adoptCopy(copy, face, this.#parts)
      return copy
    }
    Object.assign(this.#material, { clone })
    face.onDispose(() => this.end())
  }

  end(): void {
    this.#face = null
    this.#unwatch()
    adoptions.delete(this.#material)
    delete (this.#material as Partial<Material>).clone
  }

  /** Returns the loaded face if `mesh` shares the blendshape weights and skeleton of that face, otherwise undefined. */
  faceOf(mesh: Mesh): WrinklesBase | undefined {
    return this.#face && this.#meshes.some((part) => sharesPose(part, mesh)) ? this.#face : undefined
  }

  #onDraw(mesh: Mesh, renderer: AnyRenderer, camera: Camera, scene: Scene): void {
    if (isReliefMesh(mesh)) return
    if (this.#meshes.includes(mesh)) {
      this.#isShown = true
      return
    }
    if (!this.#face) return
    const face = this.faceOf(mesh)
    if (!face) {
      afterFrame(() => this.#separate(mesh))
      return
    }
    meshOf(face).prepareIn(scene, renderer, camera, mesh)
    if (this.#copyOf && !this.#guests.has(mesh)) this.#host(mesh, face, this.#copyOf)
  }

  /**
   * Disposes of a cloned face when the page removes the last mesh that shows it. The component `<Clone>` of drei clones a face with a
   * skeleton, and never disposes of the clone. `<Clone>` does not draw the clone. It draws other meshes that use the clone's blendshape
   * weights and skeleton.
   */
  #host(mesh: Mesh, face: WrinklesBase, source: WrinklesBase): void {
    this.#guests.add(mesh)
    whenRemoved(mesh, face, () => {
      this.#guests.delete(mesh)
      if (this.#isShown || this.#guests.size > 0) return
      face.dispose()
      adoptCopy(this.#material, source, this.#parts)
    })
  }

  #separate(mesh: Mesh): void {
    const face = this.#face
    // Each render pass of a frame calls this method, so the mesh may already be separate. The page may also have changed the mesh.
    if (!face || surfaceOf(mesh) !== this.#material || this.faceOf(mesh)) return
    const known = this.#copies.get(mesh)
    const copy = known ?? meshOf(face).cloneSurface()
    mesh.material = withSurface(mesh, this.#material, copy)
    if (known) return
    this.#copies.set(mesh, copy)
    addUntilRemoved(mesh, face, this.#parts, () => {
      this.#copies.delete(mesh)
      if (surfaceOf(mesh) === copy) mesh.material = withSurface(mesh, copy, this.#material)
    })
  }
}

/** Adds wrinkles to the first mesh that is drawn with a copy of a face's material. */
function adoptCopy(copy: Material, source: WrinklesBase, parts: AdoptionParts): void {
  const unwatch = parts.watch(copy, (mesh) => {
    if (isReliefMesh(mesh)) return
    unwatch()
    afterFrame(() => addUntilRemoved(mesh, source, parts, () => adoptCopy(copy, source, parts)))
  })
}

/** Calls a function after the current frame, because adding a face may resize textures that the frame reads. */
function afterFrame(change: () => void): void {
  queueMicrotask(change)
}

function addUntilRemoved(
  mesh: Mesh,
  source: WrinklesBase,
  parts: AdoptionParts,
  onRemoved: () => void,
): void {
  const face = parts.add(mesh, source)
  whenRemoved(mesh, face, () => {
    face?.dispose()
    onRemoved()
  })
}

/** Calls a function once when a mesh is removed from its parent. Does not call it if the face is disposed of earlier. */
function whenRemoved(mesh: Mesh, face: WrinklesBase | undefined, run: () => void): void {
  const remove = () => {
    mesh.removeEventListener('removed', remove)
    run()
  }
  mesh.addEventListener('removed', remove)
  face?.onDispose(() => mesh.removeEventListener('removed', remove))
}

type Skinned = Mesh & { skeleton?: object }

function sharesPose(a: Skinned, b: Skinned): boolean {
  if (instancesOf(a) || instancesOf(b)) return false
  return a.morphTargetInfluences === b.morphTargetInfluences && a.skeleton === b.skeleton
}
