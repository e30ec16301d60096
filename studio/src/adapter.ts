import { isWebGL } from '../../stage/light.ts'
import type { Renderer, RendererKind } from '../../stage/stage.ts'

/** Why a renderer cannot be had here, as one sentence; null when it can. */
export async function whyNot(kind: RendererKind): Promise<string | null> {
  if (kind === 'webgl') return null
  if (!navigator.gpu) {
    const secure = window.isSecureContext ? '' : ' on a page that is not served over https or from localhost'
    return `Studio: WebGPU is missing in this browser${secure}; the face stays on WebGL 2`
  }
  if (await navigator.gpu.requestAdapter()) return null
  return 'Studio: this browser knows WebGPU but found no graphics adapter for it; the face stays on WebGL 2'
}

/** What a renderer runs on, as the driver names it. */
export function adapterName(renderer: Renderer): string {
  const gl = isWebGL(renderer) ? renderer.getContext() : backendOf(renderer)?.gl
  if (gl) {
    const names = gl.getExtension('WEBGL_debug_renderer_info')
    return String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER))
  }
  const info = deviceOf(renderer)?.adapterInfo
  const words = [info?.description || info?.device, info?.vendor, info?.architecture]
  return [...new Set(words.filter(Boolean))].join(', ') || 'adapter not named'
}

/** The device of a renderer on WebGPU, undefined for others. Its loss is for good, whatever the reason. */
export function deviceOf(renderer: Renderer): GPUDevice | undefined {
  return backendOf(renderer)?.device
}

function backendOf(renderer: Renderer) {
  return (renderer as { backend?: { gl?: WebGL2RenderingContext; device?: GPUDevice } }).backend
}
