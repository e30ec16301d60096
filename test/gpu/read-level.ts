import type { Texture, WebGLRenderer } from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import type { Harness } from './harness.ts'

/**
 * Reads one mipmap level of a texture, or of a slice of an array, back from the GPU: bytes, top row first.
 *
 * @param slice index of the slice in an array texture; null for other textures.
 */
export async function readLevel(
  { renderer }: Harness,
  texture: Texture,
  slice: number | null,
  level: number,
): Promise<Uint8Array> {
  const { width, height, data, depth } = texture.image as {
    width: number
    height: number
    /** Absent in textures of render targets. */
    data?: Uint8Array
    depth?: number
  }
  const size = [Math.max(1, width >> level), Math.max(1, height >> level)] as const
  const channels = data ? data.length / (width * height * (depth ?? 1)) : 4
  if (data) renderer.initTexture(texture)
  const { backend } = renderer as WebGPURenderer & {
    backend?: { device?: GPUDevice; gl?: WebGL2RenderingContext; get(key: object): Textures }
  }
  if (backend?.device)
    return fromDevice(backend.device, backend.get(texture).texture, size, channels, slice ?? 0, level)
  const gl = backend?.gl ?? ((renderer as WebGLRenderer).getContext() as WebGL2RenderingContext)
  const properties = (renderer as WebGLRenderer).properties?.get(texture) as Textures | undefined
  return fromContext(
    gl,
    backend?.get(texture).textureGPU ?? properties!.__webglTexture,
    size,
    channels,
    slice,
    level,
  )
}

/** Fields in which three.js stores the GPU texture: on WebGPU, on its WebGL 2 backend, and in `WebGLRenderer`. */
interface Textures {
  texture: GPUTexture
  textureGPU: WebGLTexture
  __webglTexture: WebGLTexture
}

function fromContext(
  gl: WebGL2RenderingContext,
  texture: WebGLTexture,
  [width, height]: readonly [number, number],
  channels: number,
  slice: number | null,
  level: number,
): Uint8Array {
  const framebuffer = gl.createFramebuffer()
  const before = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING)
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer)
  const attached = [gl.READ_FRAMEBUFFER, gl.COLOR_ATTACHMENT0] as const
  if (slice === null) gl.framebufferTexture2D(...attached, gl.TEXTURE_2D, texture, level)
  else gl.framebufferTextureLayer(...attached, texture, level, slice)
  const rgba = new Uint8Array(4 * width * height)
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, rgba)
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, before)
  gl.deleteFramebuffer(framebuffer)
  return rgba.filter((_, i) => i % 4 < channels)
}

async function fromDevice(
  device: GPUDevice,
  texture: GPUTexture,
  [width, height]: readonly [number, number],
  channels: number,
  slice: number,
  level: number,
): Promise<Uint8Array> {
  const bytesPerRow = Math.ceil((width * channels) / 256) * 256
  const usage = GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ
  const buffer = device.createBuffer({ size: bytesPerRow * height, usage })
  const encoder = device.createCommandEncoder()
  const source = { texture, mipLevel: level, origin: [0, 0, slice] }
  encoder.copyTextureToBuffer(source, { buffer, bytesPerRow }, [width, height, 1])
  device.queue.submit([encoder.finish()])
  await buffer.mapAsync(GPUMapMode.READ)
  const rows = new Uint8Array(buffer.getMappedRange())
  const bytes = new Uint8Array(width * height * channels)
  for (let y = 0; y < height; y++) {
    bytes.set(rows.subarray(y * bytesPerRow, y * bytesPerRow + width * channels), y * width * channels)
  }
  buffer.destroy()
  return bytes
}
