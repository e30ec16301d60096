// Makes Node a place where the benchmark's page runs: Dawn (npm `webgpu`) in place of a browser's WebGPU, sharp in place of
// its image decoders, and a canvas that nobody sees.

import sharp from 'sharp'
import { Texture } from 'three'
import { create, globals } from 'webgpu'

/** Decoded pixels in place of an `ImageBitmap`, which only a browser can upload: RGBA bytes. */
class Pixels {
  constructor(data, { width, height }) {
    Object.assign(this, { data, width, height })
  }
  close() {}
}

/** three.js tells of its downloads by it. */
class ProgressEvent extends Event {}

/** @throws Error where Dawn finds no adapter. */
export async function becomeBrowser() {
  // Rounded to a tenth of a millisecond, as for pages that are not trusted, times would be coarser than many a frame.
  const gpu = create(['disable-dawn-features=timestamp_quantization'])
  if (!(await gpu.requestAdapter())) {
    throw new Error(
      'bench: Dawn finds no adapter; install a Vulkan driver, or name one in VK_DRIVER_FILES (see bench/README.md)',
    )
  }
  Object.defineProperty(globalThis, 'navigator', { value: { gpu, userAgent: 'Node' }, configurable: true })
  Object.assign(globalThis, globals, {
    self: globalThis,
    document: { createElementNS: createCanvas },
    requestAnimationFrame: () => 0,
    cancelAnimationFrame() {},
    ProgressEvent,
    ImageBitmap: Pixels,
    createImageBitmap: decode,
  })
  uploadPixels()
}

/** All of the benchmark's frames go to a target. */
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
  return new Pixels(new Uint8Array(data), info)
}

/** Textures of decoded pixels count as three.js's data textures, which it uploads from memory. */
function uploadPixels() {
  Object.defineProperty(Texture.prototype, 'isDataTexture', {
    get() {
      return this.image instanceof Pixels
    },
    set(value) {
      Object.defineProperty(this, 'isDataTexture', { value })
    },
  })
}
