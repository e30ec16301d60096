import type { Object3D } from 'three'

/** Whether an object is a `ReliefMesh`, which draws the displaced surface of its parent. */
export function isReliefMesh(object: Object3D): boolean {
  return 'isReliefMesh' in object
}
