import { WrinkleLoaderPlugin as WebGLPlugin, Wrinkles as WebGLWrinkles } from 'furrow/three'
import { WrinkleLoaderPlugin as WebGPUPlugin, Wrinkles as WebGPUWrinkles } from 'furrow/webgpu'
import {
  BufferAttribute,
  type Camera,
  FloatType,
  type Material,
  Mesh,
  OrthographicCamera,
  PlaneGeometry,
  RenderTarget,
  type Scene,
  UnsignedByteType,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three'
import { WebGPURenderer } from 'three/webgpu'
import { afterAll, beforeAll, inject } from 'vitest'
import { available } from './available.ts'

const PATHS = ['webgl', 'webgpu', 'webgpu on webgl2'] as const
export type RendererName = (typeof PATHS)[number]

/** Rendering paths to test. A quick run skips `WebGPURenderer` on WebGL 2, because it uses the same nodes as on WebGPU. */
export const RENDERERS: readonly RendererName[] = available(inject('inDepth') ? PATHS : ['webgl', 'webgpu'])

/** Returns the number of random cases to compare with the reference: `all`, or a quarter of it in a quick run. */
export const casesIn = (all: number) => (inject('inDepth') ? all : Math.ceil(all / 4))

/** Returns the number of random cases on a rendering path. `WebGPURenderer` on WebGL 2 has fewer, because it uses the same nodes as on WebGPU. */
export const casesOn = (name: RendererName) => casesIn(name === 'webgpu on webgl2' ? 50 : 200)

export interface Harness {
  name: RendererName
  renderer: WebGLRenderer | WebGPURenderer
  Wrinkles: typeof WebGLWrinkles | typeof WebGPUWrinkles
  Plugin: typeof WebGLPlugin | typeof WebGPUPlugin
  /** Name of the graphics adapter as reported by its driver. */
  adapter: string
  /** Renders into a target and reads it back: linear RGBA, floats in 0..1, row 0 at the bottom. */
  render(scene: Scene, camera: Camera, width: number, height?: number): Promise<Float32Array>
  /** Renders into 8 bits per channel. */
  renderBytes(scene: Scene, camera: Camera, width: number, height?: number): Promise<Uint8Array>
  /** Number of live shader programs. */
  programs(): number
  dispose(): void
}

/** Creates a renderer. Throws if it is not available, or if WebGPU falls back to WebGL 2. */
export async function createHarness(name: RendererName): Promise<Harness> {
  const canvas = document.createElement('canvas')
  const renderer =
    name === 'webgl'
      ? new WebGLRenderer({ canvas })
      : new WebGPURenderer({ canvas, forceWebGL: name !== 'webgpu' })
  if (renderer instanceof WebGPURenderer) await renderer.init()
  const read = async (
    scene: Scene,
    camera: Camera,
    width: number,
    height: number,
    type: typeof FloatType | typeof UnsignedByteType,
  ) => {
    const target =
      name === 'webgl'
        ? new WebGLRenderTarget(width, height, { type })
        : new RenderTarget(width, height, { type })
    renderer.setRenderTarget(target as WebGLRenderTarget)
    renderer.render(scene, camera)
    renderer.setRenderTarget(null)
    const pixels = await readBack(renderer, target, width, height)
    target.dispose()
    return pixels
  }
  return {
    name,
    renderer,
    Wrinkles: name === 'webgl' ? WebGLWrinkles : WebGPUWrinkles,
    Plugin: name === 'webgl' ? WebGLPlugin : WebGPUPlugin,
    adapter: adapterName(renderer, name),
    render: async (scene, camera, width, height = width) =>
      (await read(scene, camera, width, height, FloatType)) as Float32Array,
    renderBytes: async (scene, camera, width, height = width) =>
      (await read(scene, camera, width, height, UnsignedByteType)) as Uint8Array,
    programs: () =>
      renderer instanceof WebGLRenderer
        ? renderer.info.programs!.length
        : (renderer.info.memory as unknown as { programs: number }).programs,
    dispose: () => renderer.dispose(),
  }
}

/** Creates a harness for all tests in the current `describe`. */
export function harnessOn(name: RendererName): Harness {
  const harness = {} as Harness
  beforeAll(async () => void Object.assign(harness, await createHarness(name)))
  afterAll(() => harness.dispose())
  return harness
}

/**
 * Creates a square that fills the frame. `uv = (x, 1 - y) * scale + offset`, where x and y rise from 0 at the lower left corner to 1. So v points
 * down as in glTF.
 */
export function square(material: Material, scale = 1, offset = [0, 0]): Mesh {
  const geometry = new PlaneGeometry(2, 2)
  const uv = [0, 0, 1, 0, 0, 1, 1, 1].map((value, i) => value * scale + offset[i % 2])
  geometry.setAttribute('uv', new BufferAttribute(new Float32Array(uv), 2))
  return new Mesh(geometry, material)
}

/** Creates a camera. The mesh of `square` fills the picture. */
export function squareCamera(): OrthographicCamera {
  const camera = new OrthographicCamera(-1, 1, 1, -1, 0, 10)
  camera.position.z = 5
  return camera
}

/** Returns the number of render calls so far, including nested calls. */
export function imagesOf({ info }: WebGLRenderer | WebGPURenderer): number {
  return 'calls' in info ? info.calls : info.render.frame
}

async function readBack(
  renderer: WebGLRenderer | WebGPURenderer,
  target: RenderTarget,
  width: number,
  height: number,
) {
  if (renderer instanceof WebGLRenderer) {
    const pixels =
      target.texture.type === FloatType
        ? new Float32Array(width * height * 4)
        : new Uint8Array(width * height * 4)
    await renderer.readRenderTargetPixelsAsync(target as WebGLRenderTarget, 0, 0, width, height, pixels)
    return pixels
  }
  const pixels = (await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height)) as
    | Float32Array
    | Uint8Array
  const onWebGPU = (renderer.backend as { isWebGPUBackend?: boolean }).isWebGPUBackend === true
  return onWebGPU ? flipRows(unpadded(pixels, width, height), width, height) : pixels
}

/** Removes the padding of rows. On WebGPU, three.js r186 returns rows padded to 256 bytes. */
function unpadded<T extends Float32Array | Uint8Array>(pixels: T, width: number, height: number): T {
  const row = width * 4
  if (pixels.length === row * height) return pixels
  const stride = (Math.ceil((row * pixels.BYTES_PER_ELEMENT) / 256) * 256) / pixels.BYTES_PER_ELEMENT
  const rows = pixels.slice(0, row * height) as T
  for (let y = 0; y < height; y++) rows.set(pixels.subarray(y * stride, y * stride + row), y * row)
  return rows
}

/** Reverses the order of rows, because WebGPU returns the top row first. */
function flipRows<T extends Float32Array | Uint8Array>(pixels: T, width: number, height: number): T {
  const rows = pixels.slice() as T
  const stride = width * 4
  for (let y = 0; y < height; y++) {
    rows.set(pixels.subarray((height - 1 - y) * stride, (height - y) * stride), y * stride)
  }
  return rows
}

function adapterName(renderer: WebGLRenderer | WebGPURenderer, name: RendererName): string {
  const gl =
    renderer instanceof WebGLRenderer
      ? renderer.getContext()
      : (renderer.backend as { gl?: WebGL2RenderingContext }).gl
  if (gl) {
    const debugInfo = gl.getExtension('WEBGL_debug_renderer_info')
    return String(gl.getParameter(debugInfo ? debugInfo.UNMASKED_RENDERER_WEBGL : gl.RENDERER))
  }
  const device = (
    renderer as WebGPURenderer & {
      backend: { device?: { adapterInfo?: { vendor: string; architecture: string; description: string } } }
    }
  ).backend.device
  if (!device) throw new Error(`${name}: WebGPU is not available, the renderer fell back to WebGL 2`)
  const { vendor, architecture, description } = device.adapterInfo!
  return `${vendor} ${architecture} ${description}`.trim()
}
