import { type Camera, type Material, type Mesh, Object3D, type Scene } from 'three'
import type { AnyRenderer } from '../renderer.ts'

type Call = (renderer: AnyRenderer, camera: Camera, scene: Scene, drawn: object) => void

/** `onBeforeRender` callbacks that call only code of three.js and Furrow, and no callback of the page. */
const ownCallbacks = new WeakSet<Mesh['onBeforeRender']>([Object3D.prototype.onBeforeRender])

export function markReplacement(before: Mesh['onBeforeRender'], after: Mesh['onBeforeRender']): void {
  if (ownCallbacks.has(before)) ownCallbacks.add(after)
}

/** Whether the page has set `onBeforeRender` of a mesh. That callback may still change the mesh's inputs before the mesh is drawn. */
export function isPrepared({ onBeforeRender }: Mesh): boolean {
  return !ownCallbacks.has(onBeforeRender)
}

/**
 * Calls a function before each draw of a mesh or scene, or before each draw with a material. The existing `onBeforeRender` is called first.
 *
 * @returns a function that restores the existing `onBeforeRender`.
 */
export function callBeforeRender(owner: Mesh | Scene | Material, prepare: Call): () => void {
  // Materials have this callback too. As the argument `drawn`, three.js passes the material to a mesh, and the mesh to a material.
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
