import { type Camera, type Mesh, type PerspectiveCamera, Sphere, Vector3 } from 'three'
import type { AnyRenderer } from '../renderer.ts'

const sphere = new Sphere()
const eye = new Vector3()

/**
 * Opacity of wrinkles by the size of a mesh in the current picture.
 *
 * @param fadeBelow pixels, see `WrinklesOptions`.
 * @returns 0 (hidden) to 1 (fully visible).
 */
export function fadeOnScreen(mesh: Mesh, camera: Camera, renderer: AnyRenderer, fadeBelow: number): number {
  return Math.min(1, Math.max(0, (2 * sizeOnScreen(mesh, camera, renderer)) / fadeBelow - 1))
}

/** Pixels per local unit at the centre of a mesh, in the current picture; Infinity if the camera is inside its bounding sphere. */
export function pixelsPerUnit(mesh: Mesh, camera: Camera, renderer: AnyRenderer): number {
  const size = sizeOnScreen(mesh, camera, renderer)
  return size / (2 * mesh.geometry.boundingSphere!.radius)
}

/** Diameter of a mesh's bounding sphere in the current picture, pixels; Infinity if the camera is inside the sphere. */
export function sizeOnScreen(mesh: Mesh, camera: Camera, renderer: AnyRenderer): number {
  const { geometry } = mesh
  if (geometry.boundingSphere === null) geometry.computeBoundingSphere()
  sphere.copy(geometry.boundingSphere!).applyMatrix4(mesh.matrixWorld)
  const { height } = pictureOf(renderer)
  // Element 5 of a projection matrix converts a height in view space to a fraction of half the screen.
  const diameter = Math.abs(camera.projectionMatrix.elements[5]) * sphere.radius
  if (!(camera as PerspectiveCamera).isPerspectiveCamera) return diameter * height
  const distance = eye.setFromMatrixPosition(camera.matrixWorld).distanceTo(sphere.center)
  return distance > sphere.radius ? (diameter / distance) * height : Infinity
}

/** Size of the current render target or canvas, pixels. */
export function pictureOf(renderer: AnyRenderer): { width: number; height: number } {
  return renderer.getRenderTarget() ?? renderer.domElement
}
