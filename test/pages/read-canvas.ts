import type { Page } from 'playwright-core'
import sharp from 'sharp'

/** RGB bytes of a canvas, row 0 at the top. */
export interface CanvasPixels {
  width: number
  height: number
  data: Uint8Array
}

// Declares WebGPU constants, which TypeScript's own types lack.
declare const GPUTextureUsage: Record<'RENDER_ATTACHMENT' | 'COPY_SRC', number>
declare const GPUBufferUsage: Record<'COPY_DST' | 'MAP_READ', number>
declare const GPUMapMode: Record<'READ', number>

declare global {
  interface Window {
    readWebGPUCanvas?: () => Promise<string>
  }
}

/**
 * Makes the canvas of a page readable at any time. Call before navigation. WebGPU draws into a separate texture, because headless
 * Chromium without a GPU loses the device when it presents a canvas.
 */
export async function makeCanvasReadable(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const getContext = HTMLCanvasElement.prototype.getContext as (kind: string, options?: object) => unknown
    const contexts = new WeakMap<HTMLCanvasElement, object>()
    HTMLCanvasElement.prototype.getContext = function (
      this: HTMLCanvasElement,
      kind: string,
      options?: object,
    ) {
      if (kind !== 'webgpu') {
        return getContext.call(
          this,
          kind,
          kind === 'webgl2' ? { ...options, preserveDrawingBuffer: true } : options,
        )
      }
      if (!contexts.has(this)) contexts.set(this, offscreenContext(this))
      return contexts.get(this)
    } as HTMLCanvasElement['getContext']

    /** Creates the part of GPUCanvasContext that three.js uses. */
    function offscreenContext(canvas: HTMLCanvasElement): object {
      let configuration: GPUCanvasConfiguration
      let texture: GPUTexture | undefined
      window.readWebGPUCanvas = async () => (texture ? read(configuration.device, texture) : blank())
      return {
        canvas,
        configure(newConfiguration: GPUCanvasConfiguration) {
          configuration = newConfiguration
        },
        unconfigure() {},
        getConfiguration: () => configuration,
        getCurrentTexture() {
          const { width, height } = canvas
          if (texture?.width === width && texture.height === height) return texture
          texture?.destroy()
          const { device, format } = configuration
          const usage = GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC
          texture = device.createTexture({ size: [width, height], format, usage })
          return texture
        },
      }
    }

    function blank(): string {
      return document.createElement('canvas').toDataURL()
    }

    async function read(device: GPUDevice, texture: GPUTexture): Promise<string> {
      const { width, height } = texture
      const bytesPerRow = Math.ceil((width * 4) / 256) * 256
      const usage = GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ
      const buffer = device.createBuffer({ size: bytesPerRow * height, usage })
      const encoder = device.createCommandEncoder()
      encoder.copyTextureToBuffer({ texture }, { buffer, bytesPerRow }, [width, height])
      device.queue.submit([encoder.finish()])
      await buffer.mapAsync(GPUMapMode.READ)
      const padded = new Uint8Array(buffer.getMappedRange())
      const channels = texture.format.startsWith('bgra') ? [2, 1, 0] : [0, 1, 2]
      const image = new ImageData(width, height)
      for (let i = 0; i < width * height; i++) {
        const from = Math.floor(i / width) * bytesPerRow + (i % width) * 4
        for (let k = 0; k < 3; k++) image.data[4 * i + k] = padded[from + channels[k]]
        image.data[4 * i + 3] = 255
      }
      buffer.destroy()
      const canvas = document.createElement('canvas')
      Object.assign(canvas, { width, height })
      canvas.getContext('2d')!.putImageData(image, 0, 0)
      return canvas.toDataURL()
    }
  })
}

/** Reads the last frame of the page's first canvas. */
export async function readCanvas(page: Page): Promise<CanvasPixels> {
  const dataUrl = await page.evaluate(async () =>
    window.readWebGPUCanvas ? window.readWebGPUCanvas() : document.querySelector('canvas')!.toDataURL(),
  )
  const png = Buffer.from(dataUrl.slice(dataUrl.indexOf(',') + 1), 'base64')
  const { data, info } = await sharp(png).removeAlpha().raw().toBuffer({ resolveWithObject: true })
  return { width: info.width, height: info.height, data }
}
