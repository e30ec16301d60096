import { FurrowError } from '../../core/error.ts'
import type { RgbaImage } from '../../core/types.ts'

export type Drawable = ImageBitmap | HTMLImageElement | HTMLCanvasElement | OffscreenCanvas

/**
 * Reads the exact pixels of a decoded image. Uses WebGL, because a 2D canvas loses colours where alpha is small. These colours matter, because
 * each of the four channels may store a separate gray image.
 */
export function readImage(image: Drawable): RgbaImage {
  const { width, height } = image
  // Outside browsers, a replacement of `createImageBitmap` may return an object with pixels.
  if (hasPixels(image)) return image
  const gl = reader()
  if (!gl) return readWithoutWebGL(image)
  const texture = gl.createTexture()
  const framebuffer = gl.createFramebuffer()
  gl.bindTexture(gl.TEXTURE_2D, texture)
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false)
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE)
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, image)
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer)
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0)
  const data = new Uint8Array(width * height * 4)
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data)
  const error = gl.getError()
  gl.deleteFramebuffer(framebuffer)
  gl.deleteTexture(texture)
  if (error === gl.NO_ERROR) return { width, height, data }
  throw new FurrowError({
    code: 'unsupported',
    who: 'readImage',
    problem: 'WebGL cannot read the image',
    value: `${width} x ${height}, WebGL error ${error}`,
    limit: `at most ${gl.getParameter(gl.MAX_TEXTURE_SIZE)} texels per side`,
    remedy: 'scale the image down',
  })
}

let context: WebGL2RenderingContext | null = null

/** Returns a shared WebGL context, because browsers allow only a few per page. Returns null if there is none, as in workers of WebKitGTK. */
function reader(): WebGL2RenderingContext | null {
  if (!context || context.isContextLost()) context = createCanvas(1, 1).getContext('webgl2')
  return context
}

/** Creates a canvas element where possible, because more browsers can draw on it than on an `OffscreenCanvas`. */
function createCanvas(width: number, height: number): HTMLCanvasElement | OffscreenCanvas {
  if (typeof document === 'undefined') return new OffscreenCanvas(width, height)
  return Object.assign(document.createElement('canvas'), { width, height })
}

/** Reads the exact pixels of an opaque image with a 2D canvas. */
export function readOpaque(image: Drawable): RgbaImage {
  if (hasPixels(image)) return image
  const { width, height } = image
  const canvas = createCanvas(width, height)
  const context = canvas.getContext('2d', { willReadFrequently: true }) as OffscreenCanvasRenderingContext2D
  context.drawImage(image, 0, 0)
  const { data } = context.getImageData(0, 0, width, height)
  return { width, height, data: new Uint8Array(data.buffer) }
}

/** Reads an image with a 2D canvas. Throws if alpha is below 255 in any texel, because the canvas may have changed its colour. */
function readWithoutWebGL(image: Drawable): RgbaImage {
  const pixels = readOpaque(image)
  for (let i = 3; i < pixels.data.length; i += 4) if (pixels.data[i] !== 255) throw noWebGL()
  return pixels
}

function noWebGL(): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who: 'readImage',
    problem: 'reading an image with alpha needs a WebGL 2 context',
    limit: 'a browser with WebGL 2, also in workers',
    remedy: 'close other pages that use WebGL, update the browser, or save the image without alpha',
  })
}

/** Whether an object is an image with RGBA pixels. */
export function hasPixels(image: object): image is RgbaImage {
  const { data, width, height } = image as Partial<RgbaImage>
  return data instanceof Uint8Array && data.length === width! * height! * 4
}
