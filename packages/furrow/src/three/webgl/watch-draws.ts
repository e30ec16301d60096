import type { Mesh } from 'three'
import type { WatchDraws } from '../loader/adoption.ts'
import { callBeforeRender } from '../mesh/before-render.ts'

/** Watches draws of a material by `WebGLRenderer`. */
export const watchDraws: WatchDraws = (material, onDraw) =>
  callBeforeRender(material, (renderer, camera, scene, drawn) => {
    if ((drawn as Mesh).isMesh) onDraw(drawn as Mesh, renderer, camera, scene)
  })
