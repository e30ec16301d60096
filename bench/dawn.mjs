// Lets the benchmark's page run in Node: Dawn (npm `webgpu`) replaces the browser's WebGPU, sharp its image decoders, and a stub
// its canvas.

import sharp from 'sharp'
import { Texture } from 'three'
import { create, globals } from 'webgpu'

/** Decoded RGBA bytes instead of an `ImageBitmap`, which only a browser can upload. */
class PixelBitmap {
  constructor(data, { width, height }) {
    Object.assign(this, { data, width, height })
  }
  close() {}
}

/** three.js reports downloads with it. */
class ProgressEvent extends Event {}

/** @throws Error if Dawn finds no adapter. */
export async function emulateBrowser() {
  // Without quantization to 0.1 ms, which is coarser than some frames.
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

/** A stub: the benchmark draws into a render target. */
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

/** Makes textures with decoded pixels data textures to three.js, which uploads those from memory. */
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
