import type { Camera, Material, Mesh, MeshStandardMaterial, RenderTarget, Texture } from 'three'
import { nextTask } from '../../../runtime/next-task.ts'
import { rootOf } from '../../mesh/root-of.ts'
import type { AnyRenderer } from '../../renderer.ts'
import { compileFor } from '../compile-for.ts'
import type { Edit } from '../patch.ts'
import { withSurface } from '../surface.ts'
import { cloneByClass, type WrinkleMaterial } from '../wrinkle-material.ts'
import type { FaceHost } from './face-host.ts'
import type { ShownEdit } from './shown-edit.ts'

/** How a mesh of the face was drawn last. */
export interface DrawnMesh {
  camera: Camera
  /** Null for the canvas. */
  target: RenderTarget | null
}

/** What takes the place of a material's own maps during a draw. */
export interface ReplacingMaps {
  normals: Texture
  /** Null where the material's own map of occlusion stays, or where it has none. */
  occlusion: Texture | null
}

/** The meshes of the face that were drawn. */
export type DrawnMeshes = ReadonlyMap<Mesh, DrawnMesh>

/**
 * Compiles another program of a material than the default mode's while that is drawn, so that the two can change within a frame.
 * `WebGLRenderer` shares a program among materials that are alike, and keeps those that a material has had. `WebGPURenderer` shares them too,
 * and keeps one as long as a mesh with one of the materials: so copies of the material hold both.
 */
export class StandbyProgram {
  /** What the material is edited by; null for its own program. */
  readonly edit: Edit | null
  readonly #material: WrinkleMaterial
  readonly #defaultEdit: Edit
  readonly #shown: ShownEdit
  readonly #maps: ReplacingMaps
  #copies: WrinkleMaterial[] = []
  #isReady = false
  #isDisposed = false

  /**
   * @param maps the material's while this program is drawn.
   */
  constructor({ material, patch, shown }: FaceHost, edit: Edit | null, maps: ReplacingMaps) {
    this.edit = edit
    this.#material = material
    this.#defaultEdit = patch.edit
    this.#shown = shown
    this.#maps = maps
  }

  /** Whether it can be drawn. */
  get isReady(): boolean {
    return this.#isReady
  }

  /** Compiles it, if that was not done before, where it may be drawn; fulfilled when it can be. Outside of frames only. */
  async prepare(renderer: AnyRenderer, meshes: DrawnMeshes): Promise<void> {
    this.#isReady = false
    if (this.#isShared(meshes) || !isCompilable(renderer, meshes)) return
    if (this.#copies.length === 0) await this.#compile(renderer, meshes)
    this.#isReady = true
  }

  dispose(): void {
    this.#isDisposed = true
    for (const copy of this.#copies) copy.dispose()
  }

  /** Whether meshes that are not the face's have its material: they would lose their wrinkles. */
  #isShared(meshes: DrawnMeshes): boolean {
    let isShared = false
    for (const root of new Set([...meshes.keys()].map(rootOf))) {
      root.traverse((object) => {
        const { material } = object as Mesh
        if (!meshes.has(object as Mesh) && [material].flat().includes(this.#material)) isShared = true
      })
    }
    return isShared
  }

  async #compile(renderer: AnyRenderer, meshes: DrawnMeshes): Promise<void> {
    const edits = 'isWebGLRenderer' in renderer ? [this.edit] : [this.edit, this.#defaultEdit]
    for (const edit of edits) {
      for (const [mesh, drawn] of meshes) {
        // `WebGPURenderer` fails when a second compilation begins in the task of a first.
        await nextTask()
        if (this.#isDisposed) return
        const copy = this.#shown.during(edit, () => copyOf(this.#material))
        if (edit === this.edit) this.#replaceMaps(copy)
        this.#copies.push(copy)
        await this.#shown.during(edit, () => this.#compileOn(renderer, mesh, copy, drawn))
        // `WebGPURenderer` may have made its data for the copy since.
        if (this.#isDisposed) return copy.dispose()
      }
    }
  }

  /** `WebGPURenderer` builds a program with one binding for maps that are one texture, as those of glTF for occlusion and roughness are. */
  #replaceMaps(copy: WrinkleMaterial): void {
    const { normals, occlusion } = this.#maps
    copy.normalMap = normals
    if (occlusion) (copy as MeshStandardMaterial).aoMap = occlusion
  }

  async #compileOn(renderer: AnyRenderer, mesh: Mesh, copy: WrinkleMaterial, { camera, target }: DrawnMesh) {
    const { material } = mesh
    mesh.material = withSurface(mesh, this.#material, copy) as Material
    const compiled = compileFor(renderer, target, mesh, camera, rootOf(mesh))
    mesh.material = material
    await compiled
  }
}

/**
 * Whether programs can be compiled for what meshes were drawn to. Between its steps `WebGPURenderer` would leave another target than the canvas set,
 * and the page's frames would be drawn there.
 */
function isCompilable(renderer: AnyRenderer, meshes: DrawnMeshes): boolean {
  if ('isWebGLRenderer' in renderer) return true
  const targets = [renderer.getRenderTarget(), ...[...meshes.values()].map(({ target }) => target)]
  return targets.every((target) => target === null)
}

/** Copies what a program depends on. */
function copyOf(material: WrinkleMaterial): WrinkleMaterial {
  const { userData } = material
  // Copies of it are made by way of JSON; pages keep shaders there, with textures.
  material.userData = {}
  const copy = cloneByClass(material)
  material.userData = userData
  // What patches have added, in its order, by which `WebGPURenderer` knows a program. Listeners are the material's own.
  const isAdded = ([key]: [string, unknown]) => !key.startsWith('_') && !Object.hasOwn(copy, key)
  return Object.assign(copy, Object.fromEntries(Object.entries(material).filter(isAdded)))
}
