import type { Wrinkles } from 'furrow/three'
import {
  type Camera,
  LinearSRGBColorSpace,
  RenderTarget,
  type Scene,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three'
import { WebGPURenderer } from 'three/webgpu'
import type { RendererKind } from '../../stage/stage.ts'
import { type Clock, passClock, queryClock } from './timestamps.ts'

/** A three.js renderer that draws frames into a render target and measures their GPU time. */
export interface TimedRenderer {
  /** Name of the GPU. */
  adapter: string
  /** Method of timing: GPU timestamps, or elapsed CPU time until a fence after the frames is reached. */
  timing: 'timestamps' | 'fence'
  draw(scene: Scene, camera: Camera): void
  /** Draws a frame but shades only one pixel. This compiles the shaders without the cost of a full frame. */
  drawPixel(scene: Scene, camera: Camera): void
  /** Updates the influence map of `wrinkles` without drawing the scene. */
  update(wrinkles: Pick<Wrinkles, 'update'>): void
  time: Clock
  /** Returns the pixels of the last frame, RGBA bytes. */
  read(): Promise<Uint8Array>
  dispose(): void
}

/** Creates a renderer. Throws if `kind` is `webgpu` and WebGPU is missing, because three.js would fall back to WebGL 2. */
export function createTimedRenderer(
  kind: RendererKind,
  width: number,
  height: number,
): Promise<TimedRenderer> {
  return kind === 'webgl' ? createWebGL(width, height) : createWebGPU(width, height)
}

async function createWebGL(width: number, height: number): Promise<TimedRenderer> {
  const renderer = new WebGLRenderer()
  const target = new WebGLRenderTarget(width, height)
  const gl = renderer.getContext() as WebGL2RenderingContext
  const debugInfo = gl.getExtension('WEBGL_debug_renderer_info')
  const pixel = new Uint8Array(4)
  // Reading one pixel waits until the GPU has finished the frame.
  const fence = async () => renderer.readRenderTargetPixels(target, 0, 0, 1, 1, pixel)
  const clock = queryClock(gl)
  return {
    adapter: String(gl.getParameter(debugInfo ? debugInfo.UNMASKED_RENDERER_WEBGL : gl.RENDERER)),
    timing: clock ? 'timestamps' : 'fence',
    ...drawing(renderer, target, () => renderer.setRenderTarget(target)),
    update: (wrinkles) => wrinkles.update(renderer),
    time: clock ?? fenceClock(fence),
    async read() {
      const pixels = new Uint8Array(width * height * 4)
      renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels)
      return pixels
    },
    dispose() {
      renderer.dispose()
      // Browsers limit the number of contexts, and would count this one until it is garbage-collected.
      renderer.forceContextLoss()
    },
  }
}

async function createWebGPU(width: number, height: number): Promise<TimedRenderer> {
  const renderer = new WebGPURenderer()
  await renderer.init()
  const { device, isWebGPUBackend } = renderer.backend as { device?: GPUDevice; isWebGPUBackend?: boolean }
  if (!device || !isWebGPUBackend) throw new Error('bench: WebGPU is missing; use --renderer webgl')
  const target = new RenderTarget(width, height)
  // Renders to `target` instead of the canvas. In linear colour three.js adds no pass for colour conversion.
  renderer.setSize(width, height, false)
  renderer.outputColorSpace = LinearSRGBColorSpace
  renderer.setOutputRenderTarget(target)
  const { vendor, architecture, description } = device.adapterInfo
  const clock = passClock(device)
  return {
    adapter: `${vendor} ${architecture} ${description}`.trim(),
    timing: clock ? 'timestamps' : 'fence',
    ...drawing(renderer, target, () => renderer.setRenderTarget(null)),
    update: (wrinkles) => wrinkles.update(renderer),
    time: clock ?? fenceClock(() => device.queue.onSubmittedWorkDone()),
    read: async () => (await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height)) as Uint8Array,
    dispose: () => renderer.dispose(),
  }
}

function drawing(
  renderer: WebGLRenderer | WebGPURenderer,
  target: RenderTarget,
  bind: () => void,
): Pick<TimedRenderer, 'draw' | 'drawPixel'> {
  target.scissor.set(0, 0, 1, 1)
  const draw = (scene: Scene, camera: Camera, scissorTest: boolean) => {
    target.scissorTest = scissorTest
    bind()
    renderer.render(scene, camera)
  }
  return {
    draw: (scene, camera) => draw(scene, camera, false),
    drawPixel: (scene, camera) => draw(scene, camera, true),
  }
}

function fenceClock(fence: () => Promise<unknown>): Clock {
  return async (frames) => {
    const start = performance.now()
    frames()
    await fence()
    return performance.now() - start
  }
}
