import { type Camera, Ray, Raycaster, Vector2 } from 'three'

/**
 * The ray in world space through a point of the stage.
 *
 * @param x, y, width, height in CSS pixels, from the stage's upper left corner.
 */
export function rayAt(
  camera: Camera,
  [x, y]: readonly [number, number],
  [width, height]: readonly [number, number],
): Ray {
  const caster = new Raycaster()
  caster.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), camera)
  return new Ray().copy(caster.ray)
}
