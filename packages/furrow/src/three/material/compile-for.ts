import type { Camera, Object3D, RenderTarget, Scene, WebGLRenderer } from 'three'
import type { AnyRenderer } from '../renderer.ts'

/**
 * Compiles what a scene, or a part of one, is drawn into a target with, and allocates the target; fulfilled when it is compiled. Outside of
 * frames only.
 */
export async function compileFor(
  renderer: AnyRenderer,
  target: RenderTarget | null,
  scene: Object3D,
  camera: Camera,
  whole: Object3D = scene,
): Promise<void> {
  const gl = renderer as WebGLRenderer
  const before = gl.getRenderTarget()
  gl.setRenderTarget(target as never)
  const compiled = gl.compileAsync(scene, camera, whole as Scene)
  gl.setRenderTarget(before)
  await compiled
}
