import type { Camera, Mesh } from 'three'
import type { AnyRenderer } from './renderer.ts'

/** Calls a function before a mesh is drawn, behind what the mesh had for that. Returns what undoes it. */
export function callBeforeRender(
  mesh: Mesh,
  prepare: (renderer: AnyRenderer, camera: Camera) => void,
): () => void {
  const before = mesh.onBeforeRender
  // All parameters by name: a rest parameter would allocate in every frame.
  const both: Mesh['onBeforeRender'] = (renderer, scene, camera, geometry, material, group) => {
    before.call(mesh, renderer, scene, camera, geometry, material, group)
    prepare(renderer as AnyRenderer, camera)
  }
  mesh.onBeforeRender = both
  return () => {
    if (mesh.onBeforeRender === both) mesh.onBeforeRender = before
  }
}
