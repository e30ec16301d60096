import { type Camera, RenderTarget, type Scene, WebGLRenderer, WebGLRenderTarget } from 'three'
import { WebGPURenderer } from 'three/webgpu'
import type { RendererKind } from './case.ts'
import { type Clock, passClock, queryClock } from './timestamps.ts'

/** Draws frames and tells how long the adapter took. */
export interface Drawer {
  adapter: string
  /** Whether times are the adapter's own, or those until a fence behind the frames is passed. */
  timing: 'timestamps' | 'fence'
  draw(scene: Scene, camera: Camera): void
  /** Milliseconds. */
  time: Clock
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
  const gl = renderer.getContext() as WebGL2RenderingContext
  const debug = gl.getExtension('WEBGL_debug_renderer_info')
  const pixel = new Uint8Array(4)
  // One pixel of the frame cannot be read before the frame is drawn.
  const fence = async () => renderer.readRenderTargetPixels(target, 0, 0, 1, 1, pixel)
  const clock = queryClock(gl)
  return {
    adapter: String(gl.getParameter(debug ? debug.UNMASKED_RENDERER_WEBGL : gl.RENDERER)),
    timing: clock ? 'timestamps' : 'fence',
    draw(scene, camera) {
      renderer.setRenderTarget(target)
      renderer.render(scene, camera)
    },
    time: clock ?? fenceClock(fence),
    async read() {
      const pixels = new Uint8Array(width * height * 4)
      renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels)
      return pixels
    },
  }
}

async function createWebGPU(width: number, height: number): Promise<Drawer> {
  const renderer = new WebGPURenderer()
  await renderer.init()
  const { device, isWebGPUBackend } = renderer.backend as { device?: GPUDevice; isWebGPUBackend?: boolean }
  if (!device || !isWebGPUBackend) throw new Error('bench: no WebGPU here; leave out --renderer webgpu')
  const target = new RenderTarget(width, height)
  const { vendor, architecture, description } = device.adapterInfo
  const clock = passClock(device)
  return {
    adapter: `${vendor} ${architecture} ${description}`.trim(),
    timing: clock ? 'timestamps' : 'fence',
    draw(scene, camera) {
      renderer.setRenderTarget(target)
      renderer.render(scene, camera)
    },
    time: clock ?? fenceClock(() => device.queue.onSubmittedWorkDone()),
    read: async () => (await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height)) as Uint8Array,
  }
}

function fenceClock(passed: () => Promise<unknown>): Clock {
  return async (frames) => {
    const start = performance.now()
    frames()
    await passed()
    return performance.now() - start
  }
}
