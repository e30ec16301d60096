import { FurrowError, type GrayImage, type RgbaImage } from 'furrow'
import { imageTypeOf } from 'furrow/internal'
import { decodeImage } from 'furrow/three'
import type { AutoMaps } from '../document/automatic.ts'
import type { ImageFile, MapName } from '../document/document.ts'
import { bytesOf } from '../files/dropped-files.ts'

/**
 * Reads an image as a layer map.
 *
 * @param size width and height of the result, texels. The maps of all layers share an array texture, so they must have one size. Height maps
 *   are not in this texture. They keep their size, and their depth of up to 16 bits.
 * @throws FurrowError if the image is unsupported.
 */
export async function readMap(file: File, map: MapName, size: number): Promise<ImageFile> {
  const image = await decodeImage(file, file.name)
  const isUnscaled = map === 'height' || (image.width === size && image.height === size)
  const bytes = isUnscaled ? await bytesOf(file, file.name) : await scaled(image, size, file.name)
  return { mimeType: imageTypeOf(bytes) ?? 'image/png', bytes }
}

/** Encodes the maps of a layer as images. */
export async function encodeMaps(
  { blood }: AutoMaps<GrayImage>,
  layer: string,
): Promise<AutoMaps<ImageFile>> {
  return { blood: await encodeGray(blood, `blood of ${layer}`) }
}

/** Encodes a gray map as PNG, off the main thread. */
async function encodeGray({ width, height, data }: GrayImage, name: string): Promise<ImageFile> {
  const { canvas, context } = canvasOf(width, height, name)
  const image = new ImageData(width, height)
  for (let i = 0; i < data.length; i++) {
    image.data[4 * i] = image.data[4 * i + 1] = image.data[4 * i + 2] = data[i]
    image.data[4 * i + 3] = 255
  }
  context.putImageData(image, 0, 0)
  const mimeType = 'image/png'
  return { mimeType, bytes: await bytesOf(await canvas.convertToBlob({ type: mimeType }), name) }
}

async function scaled({ width, height, data }: RgbaImage, size: number, name: string): Promise<Uint8Array> {
  const image = new ImageData(Uint8ClampedArray.from(data), width, height)
  const { canvas, context } = canvasOf(size, size, name)
  context.imageSmoothingQuality = 'high'
  const bitmap = await createImageBitmap(image, { colorSpaceConversion: 'none' })
  context.drawImage(bitmap, 0, 0, size, size)
  bitmap.close()
  return bytesOf(await canvas.convertToBlob({ type: 'image/png' }), name)
}

/** Creates a canvas on the CPU. Reading a canvas on the GPU would wait for pending frames. */
function canvasOf(width: number, height: number, name: string) {
  const canvas = new OffscreenCanvas(width, height)
  const context = canvas.getContext('2d', { willReadFrequently: true })
  if (!context) throw noCanvasError(name)
  return { canvas, context }
}

function noCanvasError(name: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: `there is no canvas to draw ${name} on`,
    remedy: 'close other pages to free memory',
  })
}
