import { type Mesh, PerspectiveCamera, Scene, type WebGLRenderer } from 'three'
import { idleRenderer } from '../../../bench/idle-renderer.mjs'

/** Returns a function that prepares meshes for a frame, as a renderer does before drawing. */
export function frameOf(...meshes: Mesh[]): () => void {
  const renderer = idleRenderer()
  const drawing = renderer as unknown as WebGLRenderer
  const scene = new Scene()
  const camera = new PerspectiveCamera()
  return () => {
    renderer.info.calls++
    for (const mesh of meshes) mesh.updateWorldMatrix(true, true)
    scene.onBeforeRender(drawing, scene, camera, null as never, null as never, null as never)
    for (const mesh of meshes) {
      mesh.onBeforeRender(drawing, scene, camera, mesh.geometry, mesh.material as never, null as never)
    }
  }
}
