import { type Camera, type Material, type Mesh, Object3D, type Scene } from 'three'
import type { AnyRenderer } from '../renderer.ts'

type Call = (renderer: AnyRenderer, camera: Camera, scene: Scene, drawn: object) => void

/** Callbacks with nothing of the page's behind them. */
const ours = new WeakSet<Mesh['onBeforeRender']>([Object3D.prototype.onBeforeRender])

/** Notes that a callback does nothing of the page's but what the one before it does. */
export function replaces(before: Mesh['onBeforeRender'], after: Mesh['onBeforeRender']): void {
  if (ours.has(before)) ours.add(after)
}

/** Whether the page itself does something before a mesh is drawn. */
export function isPrepared({ onBeforeRender }: Mesh): boolean {
  return !ours.has(onBeforeRender)
}

/**
 * Calls a function before a mesh or a scene is drawn, or whatever has a material, behind what it had for that. Returns what undoes it.
 */
export function callBeforeRender(owner: Mesh | Scene | Material, prepare: Call): () => void {
  // Materials are called as meshes are, but with the object that is drawn instead of the material.
  const mesh = owner as Mesh
  const own = Object.hasOwn(mesh, 'onBeforeRender') ? mesh.onBeforeRender : null
  // All parameters by name: a rest parameter would allocate in every frame.
  const both: Mesh['onBeforeRender'] = (renderer, scene, camera, geometry, drawn, group) => {
    // A page may set the class's own at any time.
    const before = own ?? (Object.getPrototypeOf(mesh) as Mesh).onBeforeRender
    before.call(mesh, renderer, scene, camera, geometry, drawn, group)
    prepare(renderer as AnyRenderer, camera, scene as Scene, drawn)
  }
  replaces(mesh.onBeforeRender, both)
  mesh.onBeforeRender = both
  return () => {
    if (mesh.onBeforeRender !== both) return
    if (own) mesh.onBeforeRender = own
    else delete (mesh as Partial<Mesh>).onBeforeRender
  }
}
