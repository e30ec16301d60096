import { isWebGL } from '../../../stage/light.ts'
import type { Renderer, RendererKind } from '../../../stage/stage.ts'

/** Returns the reason why a renderer is unavailable, or null if it is available. */
export async function unavailableReason(kind: RendererKind): Promise<string | null> {
  if (kind === 'webgl') return null
  if (!navigator.gpu) {
    const context = window.isSecureContext ? '' : ' on a page that is not served over https or from localhost'
    return `Studio: WebGPU is missing in this browser${context}; the face stays on WebGL 2`
  }
  if (await navigator.gpu.requestAdapter()) return null
  return 'Studio: this browser supports WebGPU but finds no graphics adapter for it; the face stays on WebGL 2'
}

/** Cached names of adapters. Asking WebGL for a name waits for pending draw calls, which can take a second. */
const names = new WeakMap<Renderer, string>()

/** Returns the name of the graphics adapter, as the graphics driver reports it. */
export function adapterName(renderer: Renderer): string {
  const known = names.get(renderer)
  if (known !== undefined) return known
  const name = readAdapterName(renderer)
  names.set(renderer, name)
  return name
}

function readAdapterName(renderer: Renderer): string {
  const gl = isWebGL(renderer) ? renderer.getContext() : backendOf(renderer)?.gl
  if (gl) {
    const debugInfo = gl.getExtension('WEBGL_debug_renderer_info')
    return String(gl.getParameter(debugInfo ? debugInfo.UNMASKED_RENDERER_WEBGL : gl.RENDERER))
  }
  const info = deviceOf(renderer)?.adapterInfo
  const words = [info?.description || info?.device, info?.vendor, info?.architecture]
  return [...new Set(words.filter(Boolean))].join(', ') || 'unnamed adapter'
}

/** Returns the WebGPU device of a renderer, if any. A lost device is never restored. */
export function deviceOf(renderer: Renderer): GPUDevice | undefined {
  return backendOf(renderer)?.device
}

function backendOf(renderer: Renderer) {
  return (renderer as { backend?: { gl?: WebGL2RenderingContext; device?: GPUDevice } }).backend
}
