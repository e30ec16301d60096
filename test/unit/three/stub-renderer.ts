import { type Mesh, PerspectiveCamera, Scene, type WebGLRenderer } from 'three'
import { idleRenderer } from '../../../bench/idle-renderer.mjs'

/** Returns a function that prepares meshes for a frame as a renderer does before it draws them. */
export function frameOf(...meshes: Mesh[]): () => void {
  const renderer = idleRenderer()
  const scene = new Scene()
  const camera = new PerspectiveCamera()
  return () => {
    renderer.info.calls++
    for (const mesh of meshes) {
      mesh.updateWorldMatrix(true, true)
      mesh.onBeforeRender(
        renderer as unknown as WebGLRenderer,
        scene,
        camera,
        mesh.geometry,
        mesh.material as never,
        null as never,
      )
    }
  }
}
