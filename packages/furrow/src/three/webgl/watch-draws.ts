import type { Mesh } from 'three'
import type { WatchDraws } from '../loader/adoption.ts'

/** Watches a material as `WebGLRenderer` draws. */
export const watchDraws: WatchDraws = (material, onDraw) => {
  const { onBeforeRender } = material
  const watched: typeof onBeforeRender = (renderer, scene, camera, geometry, object, group) => {
    onBeforeRender.call(material, renderer, scene, camera, geometry, object, group)
    if ((object as Mesh).isMesh) onDraw(object as Mesh, renderer, camera)
  }
  material.onBeforeRender = watched
  return () => {
    if (material.onBeforeRender === watched) material.onBeforeRender = onBeforeRender
  }
}
