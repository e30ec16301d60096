import type { Texture } from 'three'
import { FurrowError } from '../../core/error.ts'
import type { RgbaImage } from '../../core/types.ts'
import { type Drawable, hasPixels, readImage } from '../../runtime/file/read-image.ts'

/**
 * Reads the pixels of a texture without colour conversion. Row 0 is at v = 0.
 *
 * @param who name of the texture, for errors.
 * @throws FurrowError if the image is compressed, a video, or not loaded yet.
 */
export function readTexture(texture: Texture, who: string): RgbaImage {
  const image = texture.image as object | undefined
  const pixels = image && (hasPixels(image) ? image : drawn(image))
  if (!pixels) {
    throw new FurrowError({
      code: 'unsupported',
      who,
      problem: 'texture without readable pixels',
      value: texture.name || texture.uuid,
      limit: 'a loaded image without GPU compression',
      remedy: 'await the loader first, or use the default mode',
    })
  }
  return texture.flipY ? flipped(pixels) : pixels
}

function drawn(image: object): RgbaImage | undefined {
  const drawable = [ImageBitmap, HTMLImageElement, HTMLCanvasElement, globalThis.OffscreenCanvas].some(
    (type) => type && image instanceof type,
  )
  return drawable && (image as Drawable).width > 0 ? readImage(image as Drawable) : undefined
}

function flipped({ width, height, data }: RgbaImage): RgbaImage {
  const rows = new Uint8Array(data.length)
  const stride = width * 4
  for (let y = 0; y < height; y++) {
    rows.set(data.subarray(y * stride, (y + 1) * stride), (height - 1 - y) * stride)
  }
  return { width, height, data: rows }
}
