import { FurrowError } from 'furrow'
import { drawUvLayout } from 'furrow/author'
import type { Mesh, MeshStandardMaterial } from 'three'

/** Side of the picture in texels. */
const SIZE = 2048

/**
 * Draws the UV layout of a mesh over its base colour: a template to paint areas and layers over.
 *
 * @throws FurrowError for a mesh without texture coordinates.
 */
export function drawUvPicture(mesh: Mesh): HTMLCanvasElement {
  const { position, uv } = mesh.geometry.attributes
  if (!uv) throw withoutUvs(mesh.name)
  const [{ map }] = [mesh.material].flat() as MeshStandardMaterial[]
  const canvas = document.createElement('canvas')
  canvas.width = canvas.height = SIZE
  const context = canvas.getContext('2d')
  if (!context) throw new Error('Studio: no canvas to draw the UV layout on; close other pages')
  const layout = drawUvLayout(
    {
      positions: numbersOf(position.count, (i) => [position.getX(i), position.getY(i), position.getZ(i)]),
      uvs: numbersOf(uv.count, (i) => [uv.getX(i), uv.getY(i)]),
      ...(mesh.geometry.index && { indices: mesh.geometry.index.array }),
    },
    SIZE,
    map?.image ? { base: pixelsOf(map.image as CanvasImageSource, context) } : {},
  )
  context.putImageData(new ImageData(Uint8ClampedArray.from(layout.data), SIZE, SIZE), 0, 0)
  return canvas
}

function numbersOf(count: number, at: (index: number) => number[]): number[] {
  return Array.from({ length: count }, (_, i) => at(i)).flat()
}

function pixelsOf(image: CanvasImageSource, context: CanvasRenderingContext2D) {
  context.drawImage(image, 0, 0, SIZE, SIZE)
  return { width: SIZE, height: SIZE, data: Uint8Array.from(context.getImageData(0, 0, SIZE, SIZE).data) }
}

function withoutUvs(mesh: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    what: 'a mesh without texture coordinates has no UV layout',
    value: mesh,
    remedy: 'unwrap it, and export it again',
  })
}
