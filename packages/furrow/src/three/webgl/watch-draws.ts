import type { Mesh } from 'three'
import type { WatchDraws } from '../loader/adoption.ts'
import { callBeforeRender } from '../mesh/before-render.ts'

/** Calls a function before `WebGLRenderer` draws a mesh with a material, see `WatchDraws`. */
export const watchDraws: WatchDraws = (material, onDraw) =>
  callBeforeRender(material, (renderer, camera, scene, drawn) => {
    if ((drawn as Mesh).isMesh) onDraw(drawn as Mesh, renderer, camera, scene)
  })
