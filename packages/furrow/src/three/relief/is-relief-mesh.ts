import type { Object3D } from 'three'

/** Whether an object is one that draws the relief of a mesh: it is no face of its own. */
export function isReliefMesh(object: Object3D): boolean {
  return 'isReliefMesh' in object
}
