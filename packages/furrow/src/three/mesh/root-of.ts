import type { Object3D } from 'three'

/** Returns the topmost ancestor of an object, e.g. the scene; the object itself if it has no parent. */
export function rootOf(object: Object3D): Object3D {
  return object.parent ? rootOf(object.parent) : object
}
