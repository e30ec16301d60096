import type { Camera, Material, Mesh, RenderTarget, Texture } from 'three'
import { compileFor } from '../../atlas/render-preserving-state.ts'
import type { AnyRenderer } from '../../renderer.ts'
import { rootOf } from '../../root-of.ts'
import { withSurface } from '../surface.ts'
import { cloneByClass, type WrinkleMaterial } from '../wrinkle-material.ts'

/** How a mesh of the face was drawn last. */
export interface DrawnMesh {
  camera: Camera
  target: RenderTarget | null
}

/** The meshes of the face that were drawn. */
export type DrawnMeshes = ReadonlyMap<Mesh, DrawnMesh>

/**
 * Compiles the material's own program while the default mode's is drawn, so that the two can change within a frame: `WebGLRenderer` shares a
 * program among materials that are alike, and keeps those that a material has had. `WebGPURenderer` keeps only one of each mesh, and
 * cannot compile another while the page compiles something itself.
 */
export class OwnProgram {
  readonly #material: WrinkleMaterial
  readonly #program: { isOwn: boolean }
  readonly #map: Texture
  #copy: WrinkleMaterial | null = null
  #isReady = false

  /**
   * @param program which one of the material is compiled.
   * @param map the material's normal map while its own is drawn.
   */
  constructor(material: WrinkleMaterial, program: { isOwn: boolean }, map: Texture) {
    this.#material = material
    this.#program = program
    this.#map = map
  }

  /** Whether it can be drawn. */
  get isReady(): boolean {
    return this.#isReady
  }

  /** Compiles it, if that was not done before, where it may be drawn; fulfilled when it can be. Outside of frames only. */
  async prepare(renderer: AnyRenderer, meshes: DrawnMeshes): Promise<void> {
    this.#isReady = false
    if (!('isWebGLRenderer' in renderer) || this.#isShared(meshes)) return
    if (!this.#copy) await this.#compile(renderer, meshes)
    this.#isReady = true
  }

  dispose(): void {
    this.#copy?.dispose()
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
    const copy = copyOf(this.#material)
    copy.normalMap = this.#map
    this.#copy = copy
    const { isOwn } = this.#program
    this.#program.isOwn = true
    const compiled = [...meshes].map(([mesh, { camera, target }]) => {
      const { material } = mesh
      mesh.material = withSurface(mesh, this.#material, copy) as Material
      const done = compileFor(renderer, target, mesh, camera, rootOf(mesh))
      mesh.material = material
      return done
    })
    this.#program.isOwn = isOwn
    await Promise.all(compiled)
  }
}

/** Copies what a program depends on. */
function copyOf(material: WrinkleMaterial): WrinkleMaterial {
  const { userData, onBeforeCompile, customProgramCacheKey } = material
  // Copies of it are made by way of JSON; pages keep shaders there, with textures.
  material.userData = {}
  const copy = cloneByClass(material)
  material.userData = userData
  return Object.assign(copy, { onBeforeCompile, customProgramCacheKey })
}
