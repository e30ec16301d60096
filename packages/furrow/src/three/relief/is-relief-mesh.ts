import type { Object3D } from 'three'

/** Whether an object draws the relief of another mesh. */
export function isReliefMesh(object: Object3D): boolean {
  return 'isReliefMesh' in object
}
