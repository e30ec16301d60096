import { type Camera, type Material, type Mesh, Object3D, type Scene } from 'three'
import type { AnyRenderer } from '../renderer.ts'

type Call = (renderer: AnyRenderer, camera: Camera, scene: Scene, drawn: object) => void

/** `onBeforeRender` callbacks that are known to call no code of the page. */
const ownCallbacks = new WeakSet<Mesh['onBeforeRender']>([Object3D.prototype.onBeforeRender])

/** Registers a callback that replaces another one and adds no code of the page. */
export function markReplacement(before: Mesh['onBeforeRender'], after: Mesh['onBeforeRender']): void {
  if (ownCallbacks.has(before)) ownCallbacks.add(after)
}

/** Whether the page has its own callback before a mesh is drawn. */
export function isPrepared({ onBeforeRender }: Mesh): boolean {
  return !ownCallbacks.has(onBeforeRender)
}

/**
 * Calls a function before a mesh, a scene, or any object with a material is drawn, after the existing `onBeforeRender`. Returns a function
 * that undoes this.
 */
export function callBeforeRender(owner: Mesh | Scene | Material, prepare: Call): () => void {
  // Materials get the same arguments as meshes, except the drawn object in place of the material.
  const mesh = owner as Mesh
  const existing = Object.hasOwn(mesh, 'onBeforeRender') ? mesh.onBeforeRender : null
  // No rest parameter: it would allocate in every frame.
  const hook: Mesh['onBeforeRender'] = (renderer, scene, camera, geometry, drawn, group) => {
    // The page may change the prototype's callback at any time.
    const before = existing ?? (Object.getPrototypeOf(mesh) as Mesh).onBeforeRender
    before.call(mesh, renderer, scene, camera, geometry, drawn, group)
    prepare(renderer as AnyRenderer, camera, scene as Scene, drawn)
  }
  markReplacement(mesh.onBeforeRender, hook)
  mesh.onBeforeRender = hook
  return () => {
    if (mesh.onBeforeRender !== hook) return
    if (existing) mesh.onBeforeRender = existing
    else delete (mesh as Partial<Mesh>).onBeforeRender
  }
}
