import { type Object3D, type SkinnedMesh, Vector3 } from 'three'
import type { DrawnMesh } from './drawn-mesh.ts'

/** Replacements that turn the name of a left joint into the name of the right joint. Examples: `LeftEye`, `J_Bip_L_Hand`, `hand_l`, `eyeL`. */
const MIRRORS: readonly [left: RegExp, right: string][] = [
  [/Left/, 'Right'],
  [/left/, 'right'],
  [/(^|_)L(?=_|$)/, '$1R'],
  [/(^|_)l(?=_|$)/, '$1r'],
  [/(?<=[a-z\d])L(?![a-z])/, 'R'],
]

/**
 * Finds the facing direction of a character from its left and right joints. Sums the vectors from each right joint to the left joint of the
 * same pair, and rotates the sum by -90 degrees about +Y.
 *
 * @param root root of the character, with up-to-date world matrices.
 * @param meshes meshes of the character.
 * @returns a horizontal unit vector, or a zero vector if there are no paired joints or the sum is 0.
 */
export function frontOfSides(root: Object3D, meshes: readonly DrawnMesh[]): Vector3 {
  const places = new Map<string, Vector3>()
  const add = ({ name, matrixWorld }: Object3D) => {
    if (name && !places.has(name)) places.set(name, new Vector3().setFromMatrixPosition(matrixWorld))
  }
  // Joints of a skeleton may not be descendants of the root.
  for (const { mesh } of meshes) (mesh as Partial<SkinnedMesh>).skeleton?.bones.forEach(add)
  root.traverse(add)
  const across = new Vector3()
  for (const [name, left] of places) {
    const mirror = MIRRORS.find(([pattern]) => pattern.test(name))
    const right = mirror && places.get(name.replace(...mirror))
    if (right) across.add(left).sub(right)
  }
  return new Vector3(-across.z, 0, across.x).normalize()
}
