import { type Camera, Ray, Raycaster, Vector2 } from 'three'

/**
 * Returns the world-space ray through a point of the stage.
 *
 * @param camera camera with up-to-date matrices.
 * @param position CSS pixels from the stage's upper left corner.
 * @param size stage size, CSS pixels.
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
