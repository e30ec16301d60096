import type { BufferGeometry, Camera, Material, Mesh } from 'three'
import { markReplacement } from '../mesh/before-render.ts'
import type { AnyRenderer } from '../renderer.ts'
import { followMesh, type ReliefMesh } from './relief-mesh.ts'

/** Vertex count of a draw range that draws nothing. A single vertex makes no triangle. A count of 0 would cause a warning of WebGPU. */
const NO_VERTICES = 1

/** Functions and properties of a face that a `StandIn` needs. */
export interface StandInHost {
  /** Material whose triangles the stand-in replaces. */
  readonly material: Material
  isOn(): boolean
  /** Prepares the wrinkles for the frame. Called before the dense geometry is drawn. */
  prepare(renderer: AnyRenderer, camera: Camera, mesh: Mesh): void
  /** Updates the textures with the deformed vertices of the mesh. */
  deform(renderer: AnyRenderer, isShadow: boolean): void
  /** Level of detail to draw: index of a group of the dense geometry. */
  version(): number
}

/**
 * Draws a dense geometry, i.e. a geometry with split triangles, in place of the triangles of a mesh that have a certain material. The mesh stays
 * in the scene. Its callbacks `onBeforeRender` and `onBeforeShadow` set an empty draw range. The renderers of three.js read the draw range
 * after the callbacks.
 */
export class StandIn {
  readonly #mesh: Mesh
  readonly #dense: ReliefMesh
  readonly #host: StandInHost
  #unhook: (() => void) | null = null

  constructor(mesh: Mesh, dense: ReliefMesh, host: StandInHost) {
    this.#mesh = mesh
    this.#dense = dense
    this.#host = host
    // Some pages update `matrixWorld` of the mesh themselves, and not of its children. The dense mesh therefore has the same matrix object.
    dense.matrixWorld = mesh.matrixWorld
    this.#hookDense()
  }

  get isShown(): boolean {
    return this.#unhook !== null
  }

  /** Shows or hides the dense geometry. Must not be called during a frame, because the render lists of the frame already exist. */
  show(isShown: boolean): void {
    if (isShown === this.isShown) return
    if (isShown) {
      this.follow()
      this.#mesh.add(this.#dense)
      this.#unhook = this.#hookMesh()
      return
    }
    this.#mesh.remove(this.#dense)
    this.#unhook?.()
    this.#unhook = null
  }

  /** Copies the render settings of the mesh, for the next frame. */
  follow(): void {
    followMesh(this.#dense, this.#mesh)
  }

  /**
   * Whether a draw call with this material shows the dense geometry instead of the mesh. With an override material, the mesh itself is drawn.
   */
  #isDrawnWith(material: Material): boolean {
    return material === this.#host.material && this.#isInUse
  }

  get #isInUse(): boolean {
    return this.#host.isOn() && [this.#mesh.material].flat().includes(this.#host.material)
  }

  #hookMesh(): () => void {
    const mesh = this.#mesh
    const { onBeforeRender, onAfterRender, onBeforeShadow, onAfterShadow } = mesh
    const range = new HiddenRange()
    const hooks: Pick<Mesh, 'onBeforeRender' | 'onAfterRender' | 'onBeforeShadow' | 'onAfterShadow'> = {
      onBeforeRender: (renderer, scene, camera, geometry, material, group) => {
        onBeforeRender.call(mesh, renderer, scene, camera, geometry, material, group)
        if (this.#isDrawnWith(material)) range.hide(mesh.geometry)
      },
      onAfterRender: (renderer, scene, camera, geometry, material, group) => {
        range.restore()
        onAfterRender.call(mesh, renderer, scene, camera, geometry, material, group)
      },
      onBeforeShadow: (renderer, object, camera, shadowCamera, geometry, depthMaterial, group) => {
        onBeforeShadow.call(mesh, renderer, object, camera, shadowCamera, geometry, depthMaterial, group)
        const { materialIndex = 0 } = (group ?? {}) as { materialIndex?: number }
        const { material } = mesh
        if (this.#isDrawnWith(Array.isArray(material) ? material[materialIndex] : material))
          range.hide(mesh.geometry)
      },
      onAfterShadow: (renderer, object, camera, shadowCamera, geometry, depthMaterial, group) => {
        range.restore()
        onAfterShadow.call(mesh, renderer, object, camera, shadowCamera, geometry, depthMaterial, group)
      },
    }
    Object.assign(mesh, hooks)
    markReplacement(onBeforeRender, hooks.onBeforeRender)
    const before = { onBeforeRender, onAfterRender, onBeforeShadow, onAfterShadow }
    return () => {
      for (const name of ['onBeforeRender', 'onAfterRender', 'onBeforeShadow', 'onAfterShadow'] as const) {
        if (mesh[name] === hooks[name]) Object.assign(mesh, { [name]: before[name] })
      }
    }
  }

  #hookDense(): void {
    const dense = this.#dense
    const host = this.#host
    const { geometry } = dense
    const draw = (isDrawn: boolean) => {
      const { start, count } = geometry.groups[Math.min(host.version(), geometry.groups.length - 1)]
      geometry.setDrawRange(start, isDrawn ? count : NO_VERTICES)
    }
    dense.onBeforeRender = (renderer, _scene, camera, _geometry, material) => {
      host.prepare(renderer as AnyRenderer, camera, this.#mesh)
      const isDrawn = material === dense.material && this.#isInUse
      if (isDrawn) host.deform(renderer as AnyRenderer, false)
      draw(isDrawn)
    }
    dense.onBeforeShadow = (renderer) => {
      if (this.#isInUse) host.deform(renderer as AnyRenderer, true)
      draw(this.#isInUse)
    }
  }
}

/** Hides a geometry for the duration of one draw: sets an empty draw range. */
class HiddenRange {
  #geometry: BufferGeometry | null = null
  #start = 0
  #count = 0

  hide(geometry: BufferGeometry): void {
    if (this.#geometry) return
    const { start, count } = geometry.drawRange
    this.#geometry = geometry
    this.#start = start
    this.#count = count
    geometry.setDrawRange(0, NO_VERTICES)
  }

  restore(): void {
    this.#geometry?.setDrawRange(this.#start, this.#count)
    this.#geometry = null
  }
}
