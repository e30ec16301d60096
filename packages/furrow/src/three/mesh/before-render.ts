import { type Camera, type Material, type Mesh, Object3D, type Scene } from 'three'
import type { AnyRenderer } from '../renderer.ts'

type Call = (renderer: AnyRenderer, camera: Camera, scene: Scene, drawn: object) => void

/** Callbacks that call no code of the page. */
const ours = new WeakSet<Mesh['onBeforeRender']>([Object3D.prototype.onBeforeRender])

/** Registers a callback that replaces another one and adds no code of the page. */
export function replaces(before: Mesh['onBeforeRender'], after: Mesh['onBeforeRender']): void {
  if (ours.has(before)) ours.add(after)
}

/** Whether the page has its own callback before a mesh is drawn. */
export function isPrepared({ onBeforeRender }: Mesh): boolean {
  return !ours.has(onBeforeRender)
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
  const both: Mesh['onBeforeRender'] = (renderer, scene, camera, geometry, drawn, group) => {
    // The page may change the prototype's callback at any time.
    const before = existing ?? (Object.getPrototypeOf(mesh) as Mesh).onBeforeRender
    before.call(mesh, renderer, scene, camera, geometry, drawn, group)
    prepare(renderer as AnyRenderer, camera, scene as Scene, drawn)
  }
  replaces(mesh.onBeforeRender, both)
  mesh.onBeforeRender = both
  return () => {
    if (mesh.onBeforeRender !== both) return
    if (existing) mesh.onBeforeRender = existing
    else delete (mesh as Partial<Mesh>).onBeforeRender
  }
}
