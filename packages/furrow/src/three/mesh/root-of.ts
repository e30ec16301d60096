import type { Object3D } from 'three'

/** Returns the topmost ancestor: the scene, if the object is in one. */
export function rootOf(object: Object3D): Object3D {
  return object.parent ? rootOf(object.parent) : object
}
