import type { Camera, Mesh, Scene } from 'three'
import type { AnyRenderer } from './renderer.ts'

/** Calls a function before a mesh is drawn, behind what the mesh had for that. Returns what undoes it. */
export function callBeforeRender(
  mesh: Mesh,
  prepare: (renderer: AnyRenderer, camera: Camera, scene: Scene) => void,
): () => void {
  return callAround('onBeforeRender', mesh, prepare)
}

/** The same after it is drawn. */
export function callAfterRender(
  mesh: Mesh,
  restore: (renderer: AnyRenderer, camera: Camera, scene: Scene) => void,
): () => void {
  return callAround('onAfterRender', mesh, restore)
}

function callAround(
  event: 'onBeforeRender' | 'onAfterRender',
  mesh: Mesh,
  call: (renderer: AnyRenderer, camera: Camera, scene: Scene) => void,
): () => void {
  const own = mesh[event]
  // All parameters by name: a rest parameter would allocate in every frame.
  const both: Mesh['onBeforeRender'] = (renderer, scene, camera, geometry, material, group) => {
    own.call(mesh, renderer, scene, camera, geometry, material, group)
    call(renderer as AnyRenderer, camera, scene as Scene)
  }
  mesh[event] = both
  return () => {
    if (mesh[event] === both) mesh[event] = own
  }
}
