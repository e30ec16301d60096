import type { BufferGeometry, Camera, Material, Mesh } from 'three'
import { replaces } from '../mesh/before-render.ts'
import type { AnyRenderer } from '../renderer.ts'
import { followMesh, type ReliefMesh } from './relief-mesh.ts'

/** Vertices to draw for nothing to be drawn: less than a triangle, but not 0, of which WebGPU warns. */
const NOTHING = 1

/** The wrinkles of the mesh, as far as a stand-in needs them. */
export interface StandInHost {
  /** The one of the mesh's materials in whose place it is drawn. */
  readonly material: Material
  /** Whether it shows them now. */
  isOn(): boolean
  /** Runs the phases of a frame, as before any mesh is drawn. */
  prepare(renderer: AnyRenderer, camera: Camera, mesh: Mesh): void
  /** Finds where the vertices of the mesh are now. */
  deform(renderer: AnyRenderer, isShadow: boolean): void
  /** Which version of the surface to draw: a group of the dense geometry. */
  version(): number
}

/**
 * Draws a dense geometry in place of a mesh. The mesh stays what the page knows: only that nothing of it is drawn with one of its
 * materials while the other is. Both renderers read the range to draw after `onBeforeRender` and `onBeforeShadow`.
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
    // A scene whose matrices the page updates itself knows nothing of the child.
    dense.matrixWorld = mesh.matrixWorld
    this.#hookDense()
  }

  get isShown(): boolean {
    return this.#unhook !== null
  }

  /** Begins or ends it. Not to be called during a frame: lists of what is drawn have been made. */
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

  /** Takes over how the mesh is drawn, from the next frame on. */
  follow(): void {
    followMesh(this.#dense, this.#mesh)
  }

  /** Whether the dense geometry is what is drawn with a material. Passes with another material draw the mesh itself. */
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
    replaces(onBeforeRender, hooks.onBeforeRender)
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
      geometry.setDrawRange(start, isDrawn ? count : NOTHING)
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

/** Hides a geometry for the time of one draw. */
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
    geometry.setDrawRange(0, NOTHING)
  }

  restore(): void {
    this.#geometry?.setDrawRange(this.#start, this.#count)
    this.#geometry = null
  }
}
