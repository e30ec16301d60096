import type { Object3D } from 'three'

/** The object at the top: the scene, where it is in one. */
export function rootOf(object: Object3D): Object3D {
  return object.parent ? rootOf(object.parent) : object
}
