import type { Texture } from 'three'
import { FurrowError } from '../core/error.ts'
import type { RgbaImage } from '../core/types.ts'

type Drawable = ImageBitmap | HTMLImageElement | HTMLCanvasElement | OffscreenCanvas

/**
 * Reads the pixels of a texture back as the file stored them, row 0 at v = 0.
 *
 * @throws FurrowError when the texture has no image that can be read: compressed, video, or not loaded yet.
 */
export function readTexture(texture: Texture, who: string): RgbaImage {
  const image = texture.image as (Partial<RgbaImage> & object) | undefined
  const pixels = image && (image.data instanceof Uint8Array ? raw(image as RgbaImage) : drawn(image))
  if (!pixels) {
    throw new FurrowError({
      who,
      what: 'texture without readable pixels',
      value: texture.name || texture.uuid,
      limit: 'an image that is loaded and not GPU-compressed',
      remedy: 'await the loader first, or use the default mode',
    })
  }
  return texture.flipY ? flipped(pixels) : pixels
}

/** Draws an image into memory. */
export function drawImage(image: Drawable): RgbaImage {
  const { width, height } = image
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true })!
  context.drawImage(image, 0, 0)
  return { width, height, data: new Uint8Array(context.getImageData(0, 0, width, height).data.buffer) }
}

function raw(image: RgbaImage): RgbaImage | undefined {
  return image.data.length === image.width * image.height * 4 ? image : undefined
}

function drawn(image: object): RgbaImage | undefined {
  const drawable = [ImageBitmap, HTMLImageElement, HTMLCanvasElement, OffscreenCanvas].some(
    (type) => image instanceof type,
  )
  return drawable && (image as Drawable).width > 0 ? drawImage(image as Drawable) : undefined
}

function flipped({ width, height, data }: RgbaImage): RgbaImage {
  const rows = new Uint8Array(data.length)
  const stride = width * 4
  for (let y = 0; y < height; y++) {
    rows.set(data.subarray(y * stride, (y + 1) * stride), (height - 1 - y) * stride)
  }
  return { width, height, data: rows }
}
