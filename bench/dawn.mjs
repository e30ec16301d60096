// Emulates a browser in Node, so that the benchmark's page can run there: Dawn (npm `webgpu`) provides WebGPU, and sharp decodes images.
// The canvas is a stub.

import sharp from 'sharp'
import { Texture } from 'three'
import { create, globals } from 'webgpu'

/** An image as decoded RGBA bytes. Replaces `ImageBitmap`, which only browsers can upload to the GPU. */
class PixelBitmap {
  constructor(data, { width, height }) {
    Object.assign(this, { data, width, height })
  }
  close() {}
}

/** Node lacks this class, which three.js uses to report downloads. */
class ProgressEvent extends Event {}

/** Defines the browser globals that the page uses. Throws if Dawn finds no GPU adapter. */
export async function emulateBrowser() {
  // Dawn rounds timestamps to 0.1 ms by default, but some frames are shorter.
  const gpu = create(['disable-dawn-features=timestamp_quantization'])
  if (!(await gpu.requestAdapter())) {
    throw new Error(
      'bench: Dawn finds no adapter; install a Vulkan driver or name one in VK_DRIVER_FILES (see bench/README.md)',
    )
  }
  Object.defineProperty(globalThis, 'navigator', { value: { gpu, userAgent: 'Node' }, configurable: true })
  Object.assign(globalThis, globals, {
    self: globalThis,
    document: { createElementNS: createCanvas },
    requestAnimationFrame: () => 0,
    cancelAnimationFrame() {},
    ProgressEvent,
    ImageBitmap: PixelBitmap,
    createImageBitmap: decode,
  })
  uploadPixels()
}

/** Creates a stub canvas. The benchmark never draws to a canvas, only to a render target. */
function createCanvas() {
  const context = { configure() {}, unconfigure() {} }
  return { style: {}, addEventListener() {}, removeEventListener() {}, getContext: () => context }
}

async function decode(blob) {
  const image = sharp(await blob.arrayBuffer())
    .toColourspace('srgb')
    .ensureAlpha()
    .raw()
  const { data, info } = await image.toBuffer({ resolveWithObject: true })
  return new PixelBitmap(new Uint8Array(data), info)
}

/** Makes three.js treat a texture as a data texture if its image is a `PixelBitmap`. */
function uploadPixels() {
  Object.defineProperty(Texture.prototype, 'isDataTexture', {
    get() {
      return this.image instanceof PixelBitmap
    },
    set(value) {
      Object.defineProperty(this, 'isDataTexture', { value })
    },
  })
}
