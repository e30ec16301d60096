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
  return callAround('onBeforeRender', owner as Mesh, prepare)
}

/** The same after a mesh is drawn. */
export function callAfterRender(mesh: Mesh, restore: Call): () => void {
  return callAround('onAfterRender', mesh, restore)
}

/** Materials are called as meshes are, but with the object that is drawn instead of the material. */
function callAround(event: 'onBeforeRender' | 'onAfterRender', owner: Mesh, call: Call): () => void {
  const own = Object.hasOwn(owner, event) ? owner[event] : null
  // All parameters by name: a rest parameter would allocate in every frame.
  const both: Mesh['onBeforeRender'] = (renderer, scene, camera, geometry, drawn, group) => {
    // A page may set the class's own at any time.
    const before = own ?? (Object.getPrototypeOf(owner) as Mesh)[event]
    before.call(owner, renderer, scene, camera, geometry, drawn, group)
    call(renderer as AnyRenderer, camera, scene as Scene, drawn)
  }
  replaces(owner[event], both)
  owner[event] = both
  return () => {
    if (owner[event] !== both) return
    if (own) owner[event] = own
    else delete (owner as Partial<Mesh>)[event]
  }
}
