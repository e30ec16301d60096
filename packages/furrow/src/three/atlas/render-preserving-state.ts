import { type Camera, Color, type RenderTarget, type Scene, type WebGLRenderer } from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import type { AnyRenderer } from '../renderer.ts'

const colour = new Color()

/**
 * Renders a scene into a mip level of a render target, and restores the renderer's state. May be called during another `render` call.
 *
 * @param isCleared whether to set all texels to 0 first.
 */
export function renderPreservingState(
  renderer: AnyRenderer,
  target: RenderTarget,
  scene: Scene,
  camera: Camera,
  targetLevel = 0,
  isCleared = false,
): void {
  const gl = renderer as WebGLRenderer
  const before = gl.getRenderTarget()
  const face = gl.getActiveCubeFace()
  const level = gl.getActiveMipmapLevel()
  const { autoClear } = renderer
  const { autoReset } = renderer.info
  const xr = renderer.xr.enabled
  const shadows = gl.shadowMap?.autoUpdate
  renderer.autoClear = false
  renderer.info.autoReset = false
  renderer.xr.enabled = false
  if (gl.shadowMap) gl.shadowMap.autoUpdate = false
  gl.setRenderTarget(target as never, 0, targetLevel)
  if (isCleared) clear(gl)
  if ('setMRT' in renderer) renderAll(renderer, scene, camera)
  else renderer.render(scene, camera)
  gl.setRenderTarget(before, face, level)
  if (gl.shadowMap) gl.shadowMap.autoUpdate = shadows
  renderer.xr.enabled = xr
  renderer.info.autoReset = autoReset
  renderer.autoClear = autoClear
}

/**
 * Draws all objects of a scene during another render pass of `WebGPURenderer`. That pass may have replaced the function that draws objects
 * (shadow passes do), enabled multiple outputs, or excluded opaque or transparent objects. Resets these settings while drawing.
 */
function renderAll(renderer: WebGPURenderer, scene: Scene, camera: Camera): void {
  const { opaque, transparent } = renderer
  const drawObject = renderer.getRenderObjectFunction()
  const outputs = renderer.getMRT()
  renderer.opaque = renderer.transparent = true
  // three.js's types omit that null is allowed.
  renderer.setRenderObjectFunction(null!)
  renderer.setMRT(null)
  renderer.render(scene, camera)
  renderer.setMRT(outputs)
  renderer.setRenderObjectFunction(drawObject!)
  renderer.transparent = transparent
  renderer.opaque = opaque
}

function clear(gl: WebGLRenderer): void {
  const alpha = gl.getClearAlpha()
  gl.getClearColor(colour)
  // The last material may have disabled colour writes.
  gl.state?.buffers.color.setMask(true)
  gl.setClearColor(0, 0)
  gl.clear(true, false, false)
  gl.setClearColor(colour, alpha)
}
