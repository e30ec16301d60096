import type { Camera, Material, Mesh, Scene } from 'three'
import { surfaceOf, withSurface } from '../material/surface.ts'
import { instancesOf } from '../mesh/instances.ts'
import { isReliefMesh } from '../relief/is-relief-mesh.ts'
import type { AnyRenderer } from '../renderer.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'

/**
 * Calls a function before a mesh is drawn with a material.
 *
 * @returns what ends that.
 */
export type WatchDraws = (
  material: Material,
  onDraw: (mesh: Mesh, renderer: AnyRenderer, camera: Camera, scene: Scene) => void,
) => () => void

/** What adopting a mesh takes. */
export interface AdoptionParts {
  watch: WatchDraws
  /** Adds wrinkles of its own to a mesh; undefined, and a warning, if that is not possible. */
  add(mesh: Mesh, source: WrinklesBase): WrinklesBase | undefined
}

const adoptions = new WeakMap<Material, Adoption>()

/** The face that a mesh belongs to by its material: it was made by the page, which took the material from a loaded file. */
export function adoptedBy(mesh: Mesh): WrinklesBase | undefined {
  return adoptions.get(surfaceOf(mesh))?.faceOf(mesh)
}

/**
 * Meshes that a page makes itself and draws with the material of a loaded face, as JSX of gltfjsx and drei's `<Clone>` do. One that has
 * the blendshape weights and the skeleton of a loaded mesh is the same face. Any other is a face of its own, as a copy is, until it is
 * removed from its parent. Nothing is kept of the former, and nothing happens while only loaded meshes are drawn.
 */
export class Adoption {
  readonly #material: Material
  readonly #meshes: readonly Mesh[]
  readonly #parts: AdoptionParts
  /** Of adopted meshes that are faces of their own. React may set the shared material again. */
  readonly #copies = new WeakMap<Mesh, Material>()
  readonly #unwatch: () => void
  readonly #copyOf: WrinklesBase | undefined
  /** Adopted meshes that show a copy. */
  readonly #guests = new Set<Mesh>()
  /** Whether a mesh of the face itself was drawn. */
  #isShown = false
  #face: WrinklesBase | null = null

  /**
   * To be created before the material is patched.
   *
   * @param meshes of the face.
   * @param copyOf the face of which this one is a copy.
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

  /** Begins to adopt, until the face is disposed of. */
  begin(face: WrinklesBase): void {
    this.#face = face
    adoptions.set(this.#material, this)
    // drei's `<Clone deep>`, and whoever else copies the material.
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

  /** The face, if the mesh is part of it. */
  faceOf(mesh: Mesh): WrinklesBase | undefined {
    return this.#face && this.#meshes.some((own) => movesAs(own, mesh)) ? this.#face : undefined
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
   * Disposes of a copy that only adopted meshes show when the last of them is removed, since nobody else will: drei's `<Clone>` makes
   * such a copy of a face with a skeleton, and never draws it.
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

  /** Gives a mesh wrinkles of its own. */
  #separate(mesh: Mesh): void {
    const face = this.#face
    // Several passes of one frame may have drawn it, and the page may have changed it since.
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

/** A new face may need a larger atlas, and the frame being drawn reads the old one. */
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

/** Calls a function once when a mesh is removed from its parent, unless its face was disposed of. */
function whenRemoved(mesh: Mesh, face: WrinklesBase | undefined, run: () => void): void {
  const remove = () => {
    mesh.removeEventListener('removed', remove)
    run()
  }
  mesh.addEventListener('removed', remove)
  face?.onDispose(() => mesh.removeEventListener('removed', remove))
}

type Skinned = Mesh & { skeleton?: object }

/** Whether two meshes move as one. */
function movesAs(a: Skinned, b: Skinned): boolean {
  if (instancesOf(a) || instancesOf(b)) return false
  return a.morphTargetInfluences === b.morphTargetInfluences && a.skeleton === b.skeleton
}
