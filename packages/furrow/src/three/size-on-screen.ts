import { type Camera, type Mesh, type PerspectiveCamera, Sphere, Vector3 } from 'three'
import type { AnyRenderer } from './renderer.ts'

const sphere = new Sphere()
const eye = new Vector3()

/** Diameter of a mesh's bounding sphere on the screen or target being drawn, in pixels; Infinity from within. */
export function sizeOnScreen(mesh: Mesh, camera: Camera, renderer: AnyRenderer): number {
  const { geometry } = mesh
  if (geometry.boundingSphere === null) geometry.computeBoundingSphere()
  sphere.copy(geometry.boundingSphere!).applyMatrix4(mesh.matrixWorld)
  const height = renderer.getRenderTarget()?.height ?? renderer.domElement.height
  // Element 5 of a projection turns heights into shares of half the screen.
  const share = Math.abs(camera.projectionMatrix.elements[5]) * sphere.radius
  if (!(camera as PerspectiveCamera).isPerspectiveCamera) return share * height
  const distance = eye.setFromMatrixPosition(camera.matrixWorld).distanceTo(sphere.center)
  return distance > sphere.radius ? (share / distance) * height : Infinity
}
