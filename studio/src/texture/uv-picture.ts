import { drawUvLayout } from 'furrow/internal'
import type { Mesh, MeshStandardMaterial } from 'three'
import { readSkin } from '../paint/read-skin.ts'

/** Default width and height of the picture, texels. */
const TEMPLATE_SIZE = 2048

/**
 * Draws the UV layout of a skin over its base colour, as a template for painting.
 *
 * @param meshes meshes of the skin, with one material.
 * @param size width and height of the picture, texels.
 * @throws FurrowError if a mesh has no texture coordinates.
 */
export function drawUvPicture(meshes: readonly [Mesh, ...Mesh[]], size = TEMPLATE_SIZE): HTMLCanvasElement {
  const { positions, uvs, indices } = readSkin(meshes).skin
  const canvas = document.createElement('canvas')
  canvas.width = canvas.height = size
  const context = canvas.getContext('2d', { willReadFrequently: true })
  if (!context) throw new Error('Studio: no canvas to draw the UV layout on; close other pages')
  const colour = colourOf(meshes)
  const base = colour && pixelsOf(colour, context)
  const layout = drawUvLayout({ positions, uvs, indices }, size, base ? { base } : {})
  context.putImageData(new ImageData(Uint8ClampedArray.from(layout.data), size, size), 0, 0)
  return canvas
}

/** Returns the base colour texture of a skin, or null if a canvas cannot draw it. For example, KTX 2 textures exist only on the GPU. */
export function colourOf([mesh]: readonly [Mesh, ...Mesh[]]): CanvasImageSource | null {
  const [{ map }] = [mesh.material].flat() as MeshStandardMaterial[]
  const image = map?.image as CanvasImageSource | null | undefined
  const isDrawable =
    image instanceof ImageBitmap || image instanceof HTMLImageElement || image instanceof HTMLCanvasElement
  return isDrawable ? image : null
}

function pixelsOf(image: CanvasImageSource, context: CanvasRenderingContext2D) {
  const { width, height } = context.canvas
  context.drawImage(image, 0, 0, width, height)
  return { width, height, data: Uint8Array.from(context.getImageData(0, 0, width, height).data) }
}
