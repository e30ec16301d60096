import { type Camera, Color, type RenderTarget, type Scene, type WebGLRenderer } from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import type { AnyRenderer } from '../renderer.ts'

const colour = new Color()

/**
 * Renders into a level of a target during another render call, and restores the renderer's state.
 *
 * @param isCleared whether all texels are set to 0 before; else the target keeps what it has.
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
 * Draws all of a scene, whatever is being drawn: shadows are without the meshes that cast none, and passes have several outputs, or leave out
 * what is transparent.
 */
function renderAll(renderer: WebGPURenderer, scene: Scene, camera: Camera): void {
  const { opaque, transparent } = renderer
  const drawObject = renderer.getRenderObjectFunction()
  const outputs = renderer.getMRT()
  renderer.opaque = renderer.transparent = true
  // Its types leave out that null is allowed.
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
  // A material that writes depth alone may have been drawn last.
  gl.state?.buffers.color.setMask(true)
  gl.setClearColor(0, 0)
  gl.clear(true, false, false)
  gl.setClearColor(colour, alpha)
}
