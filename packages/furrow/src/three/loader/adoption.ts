import type { Camera, Material, Mesh, Scene } from 'three'
import { surfaceOf, withSurface } from '../material/surface.ts'
import { instancesOf } from '../mesh/instances.ts'
import { isReliefMesh } from '../relief/is-relief-mesh.ts'
import type { AnyRenderer } from '../renderer.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'

/**
 * Calls a function before each draw of a mesh with a material.
 *
 * @returns a function that stops watching.
 */
export type WatchDraws = (
  material: Material,
  onDraw: (mesh: Mesh, renderer: AnyRenderer, camera: Camera, scene: Scene) => void,
) => () => void

/** Functions that `Adoption` needs from the loader. */
export interface AdoptionParts {
  watch: WatchDraws
  /** Adds separate wrinkles to a mesh. Warns and returns undefined if that fails. */
  add(mesh: Mesh, source: WrinklesBase): WrinklesBase | undefined
}

const adoptions = new WeakMap<Material, Adoption>()

/** Returns the face of a mesh that the page created with the material of a loaded file. */
export function adoptedBy(mesh: Mesh): WrinklesBase | undefined {
  return adoptions.get(surfaceOf(mesh))?.faceOf(mesh)
}

/**
 * Adopts meshes that a page creates with the material of a loaded face, as gltfjsx's JSX and drei's `<Clone>` do. A mesh that shares its
 * blendshape weights and skeleton with a loaded mesh is the same face. Any other mesh becomes a separate face until it is removed from
 * its parent. Costs nothing while only loaded meshes are drawn.
 */
export class Adoption {
  readonly #material: Material
  readonly #meshes: readonly Mesh[]
  readonly #parts: AdoptionParts
  /** Material copies of adopted meshes that are separate faces. Kept because React may set the shared material again. */
  readonly #copies = new WeakMap<Mesh, Material>()
  readonly #unwatch: () => void
  readonly #copyOf: WrinklesBase | undefined
  /** Adopted meshes that show a clone of the face. */
  readonly #guests = new Set<Mesh>()
  /** Whether one of the face's own meshes was drawn. */
  #isShown = false
  #face: WrinklesBase | null = null

  /**
   * Must be created before the material is patched.
   *
   * @param meshes meshes of the face.
   * @param copyOf face that this face is a clone of.
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

  /** Adopts meshes until the face is disposed of. */
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

  /** Returns the face if the mesh is part of it. */
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
   * Disposes of a cloned face when the last adopted mesh that shows it is removed. Required for drei's `<Clone>`, which clones faces with a
   * skeleton, but neither draws the clone nor disposes of it.
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

  /** Turns a mesh into a separate face. */
  #separate(mesh: Mesh): void {
    const face = this.#face
    // Several passes of one frame may have queued the mesh, and the page may have changed the mesh since.
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

/** Adds wrinkles to the first mesh drawn with a copy of a face's material. */
function adoptCopy(copy: Material, source: WrinklesBase, parts: AdoptionParts): void {
  const unwatch = parts.watch(copy, (mesh) => {
    if (isReliefMesh(mesh)) return
    unwatch()
    afterFrame(() => addUntilRemoved(mesh, source, parts, () => adoptCopy(copy, source, parts)))
  })
}

/** Defers a change: a new face may resize the atlas that the current frame reads. */
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

/** Calls a function once when a mesh is removed from its parent, unless its face is disposed of first. */
function whenRemoved(mesh: Mesh, face: WrinklesBase | undefined, run: () => void): void {
  const remove = () => {
    mesh.removeEventListener('removed', remove)
    run()
  }
  mesh.addEventListener('removed', remove)
  face?.onDispose(() => mesh.removeEventListener('removed', remove))
}

type Skinned = Mesh & { skeleton?: object }

/** Whether two meshes share their blendshape weights and skeleton. */
function sharesPose(a: Skinned, b: Skinned): boolean {
  if (instancesOf(a) || instancesOf(b)) return false
  return a.morphTargetInfluences === b.morphTargetInfluences && a.skeleton === b.skeleton
}
