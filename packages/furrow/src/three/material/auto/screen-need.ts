import type { Camera, Mesh, PerspectiveCamera, SkinnedMesh } from 'three'
import { pictureOf, pixelsPerUnit, sizeOnScreen } from '../../camera/size-on-screen.ts'
import type { AnyRenderer } from '../../renderer.ts'
import type { Size } from '../composed-map.ts'
import { uvLayoutOf } from '../uv-layout.ts'

/** A side is halved while it is longer. */
const SMALLEST_SIDE = 64

/**
 * Texels that a side of a map needs to be as fine as the picture being drawn wherever the mesh may be seen: Infinity where a skeleton may
 * have moved it elsewhere.
 */
export function sideOnScreen(mesh: Mesh, camera: Camera, renderer: AnyRenderer, channel: number): number {
  if ((mesh as Partial<SkinnedMesh>).isSkinnedMesh) return Infinity
  const side = uvLayoutOf(mesh.geometry, channel).unitsPerUv * pixelsPerUnit(mesh, camera, renderer)
  if (!(camera as PerspectiveCamera).isPerspectiveCamera || side === Infinity) return side
  const { height } = pictureOf(renderer)
  // The size is of the middle of the bounding sphere, so many of its radiuses away; its nearest point is one radius nearer.
  const distance =
    (Math.abs(camera.projectionMatrix.elements[5]) * height) / sizeOnScreen(mesh, camera, renderer)
  return (side * distance) / (distance - 1)
}

/** Pixels that a mesh covers, at most. */
export function pixelsOnScreen(mesh: Mesh, camera: Camera, renderer: AnyRenderer): number {
  const { width, height } = pictureOf(renderer)
  return Math.min(width * height, (Math.PI / 4) * sizeOnScreen(mesh, camera, renderer) ** 2)
}

/** How often a map's sides may be halved for a screen that needs a side of so many texels. */
export function halvingsOf({ width, height }: Size, needed: number): number {
  let side = Math.max(width, height)
  let halvings = 0
  while (side >= 2 * needed && Math.min(width, height) >> (halvings + 1) >= SMALLEST_SIDE) {
    side /= 2
    halvings++
  }
  return halvings
}
