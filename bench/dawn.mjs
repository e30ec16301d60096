// Runs the benchmark's page in Node: Dawn (npm `webgpu`) replaces the browser's WebGPU, sharp its image decoders, a stub its canvas.

import sharp from 'sharp'
import { Texture } from 'three'
import { create, globals } from 'webgpu'

/** Decoded RGBA bytes. Replaces `ImageBitmap`, which only browsers can upload. */
class PixelBitmap {
  constructor(data, { width, height }) {
    Object.assign(this, { data, width, height })
  }
  close() {}
}

/** Used by three.js to report downloads. */
class ProgressEvent extends Event {}

/** Defines the browser's globals. Throws if Dawn finds no adapter. */
export async function emulateBrowser() {
  // Quantised timestamps of 0.1 ms are coarser than some frames.
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

/** Creates a stub: the benchmark renders to a render target. */
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

/** Makes three.js upload decoded pixels as data textures. */
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
