import { type Camera, RenderTarget, type Scene, WebGLRenderer, WebGLRenderTarget } from 'three'
import { WebGPURenderer } from 'three/webgpu'
import type { RendererKind } from './case.ts'

/** Draws frames and tells when they are done. */
export interface Drawer {
  adapter: string
  draw(scene: Scene, camera: Camera): void
  /** Waits until the adapter has done all that it was given. */
  done(): Promise<void>
  /** The last frame, RGBA bytes. */
  read(): Promise<Uint8Array>
}

/** @throws Error where WebGPU is missing: a silent fall back to WebGL 2 would be measured under a wrong name. */
export function createDrawer(kind: RendererKind, width: number, height: number): Promise<Drawer> {
  return kind === 'webgl' ? createWebGL(width, height) : createWebGPU(width, height)
}

async function createWebGL(width: number, height: number): Promise<Drawer> {
  const renderer = new WebGLRenderer()
  const target = new WebGLRenderTarget(width, height)
  const gl = renderer.getContext()
  const debug = gl.getExtension('WEBGL_debug_renderer_info')
  const pixel = new Uint8Array(4)
  return {
    adapter: String(gl.getParameter(debug ? debug.UNMASKED_RENDERER_WEBGL : gl.RENDERER)),
    draw(scene, camera) {
      renderer.setRenderTarget(target)
      renderer.render(scene, camera)
    },
    // One pixel of the frame cannot be read before the frame is drawn.
    done: async () => renderer.readRenderTargetPixels(target, 0, 0, 1, 1, pixel),
    async read() {
      const pixels = new Uint8Array(width * height * 4)
      renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels)
      return pixels
    },
  }
}

interface Backend {
  isWebGPUBackend?: boolean
  device?: { queue: { onSubmittedWorkDone(): Promise<void> }; adapterInfo: Record<string, string> }
}

async function createWebGPU(width: number, height: number): Promise<Drawer> {
  const renderer = new WebGPURenderer()
  await renderer.init()
  const { device, isWebGPUBackend } = renderer.backend as unknown as Backend
  if (!device || !isWebGPUBackend) throw new Error('bench: no WebGPU here; leave out --renderer webgpu')
  const target = new RenderTarget(width, height)
  const { vendor, architecture, description } = device.adapterInfo
  return {
    adapter: `${vendor} ${architecture} ${description}`.trim(),
    draw(scene, camera) {
      renderer.setRenderTarget(target)
      renderer.render(scene, camera)
    },
    done: () => device.queue.onSubmittedWorkDone(),
    read: async () => (await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height)) as Uint8Array,
  }
}
