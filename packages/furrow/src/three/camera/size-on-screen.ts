import { type Camera, type Mesh, type PerspectiveCamera, Sphere, Vector3 } from 'three'
import type { AnyRenderer } from '../renderer.ts'

const sphere = new Sphere()
const eye = new Vector3()

/**
 * Returns the opacity of wrinkles by the size of their mesh on screen. Opacity is 1 at `fadeBelow` pixels or more, and 0 at half of
 * `fadeBelow` or less.
 *
 * @param fadeBelow pixels, see `WrinklesOptions`.
 * @returns 0 (hidden) to 1 (fully visible).
 */
export function fadeOnScreen(mesh: Mesh, camera: Camera, renderer: AnyRenderer, fadeBelow: number): number {
  return Math.min(1, Math.max(0, (2 * sizeOnScreen(mesh, camera, renderer)) / fadeBelow - 1))
}

/**
 * Returns the number of pixels that one unit of a mesh's local space covers at the centre of the mesh; Infinity if the camera is inside its
 * bounding sphere.
 */
export function pixelsPerUnit(mesh: Mesh, camera: Camera, renderer: AnyRenderer): number {
  const size = sizeOnScreen(mesh, camera, renderer)
  return size / (2 * mesh.geometry.boundingSphere!.radius)
}

/** Returns the diameter of a mesh's bounding sphere on screen, pixels; Infinity if the camera is inside the sphere. */
export function sizeOnScreen(mesh: Mesh, camera: Camera, renderer: AnyRenderer): number {
  const { geometry } = mesh
  if (geometry.boundingSphere === null) geometry.computeBoundingSphere()
  sphere.copy(geometry.boundingSphere!).applyMatrix4(mesh.matrixWorld)
  const { height } = pictureOf(renderer)
  // Element 5 of a projection matrix scales heights in view space (for a perspective camera, at distance 1) to heights in clip space, -1..1.
  const diameter = Math.abs(camera.projectionMatrix.elements[5]) * sphere.radius
  if (!(camera as PerspectiveCamera).isPerspectiveCamera) return diameter * height
  const distance = eye.setFromMatrixPosition(camera.matrixWorld).distanceTo(sphere.center)
  return distance > sphere.radius ? (diameter / distance) * height : Infinity
}

/** Returns the current render target, or the canvas if there is none. Its size is the size of the picture in pixels. */
export function pictureOf(renderer: AnyRenderer): { width: number; height: number } {
  return renderer.getRenderTarget() ?? renderer.domElement
}
