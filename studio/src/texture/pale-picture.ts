import type { Mesh } from 'three'
import { colourOf, drawUvPicture } from './uv-picture.ts'

/** Width and height of the picture, pixels. */
const SIZE = 256

const pictures = new WeakMap<Mesh, HTMLCanvasElement>()

/** Returns a small, pale picture of a skin's texture, or of the UV layout if the texture cannot be drawn. It is the background of thumbnails. */
export function palePicture(meshes: readonly [Mesh, ...Mesh[]]): HTMLCanvasElement {
  const known = pictures.get(meshes[0])
  if (known) return known
  const canvas = document.createElement('canvas')
  canvas.width = canvas.height = SIZE
  const context = canvas.getContext('2d')!
  context.filter = 'saturate(0.4) brightness(0.75)'
  context.imageSmoothingQuality = 'high'
  context.drawImage(colourOf(meshes) ?? drawUvPicture(meshes, SIZE), 0, 0, SIZE, SIZE)
  pictures.set(meshes[0], canvas)
  return canvas
}
