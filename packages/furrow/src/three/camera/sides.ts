import { type Object3D, type SkinnedMesh, Vector3 } from 'three'
import type { DrawnMesh } from './drawn-mesh.ts'

/** Names of the right side for those of the left one: `LeftEye`, `J_Bip_L_Hand`, `L_Hand`, `hand_l`, `eyeL`. */
const MIRRORS: readonly [left: RegExp, right: string][] = [
  [/Left/, 'Right'],
  [/left/, 'right'],
  [/(^|_)L(?=_|$)/, '$1R'],
  [/(^|_)l(?=_|$)/, '$1r'],
  [/(?<=[a-z\d])L(?![a-z])/, 'R'],
]

/**
 * Where a character looks, by the joints of its left and right side: left minus right, turned by a quarter round +Y.
 *
 * @param root of the character. World matrices must be up to date.
 * @param meshes of the character.
 * @returns length 1, horizontal; 0 where no joints have such names, or they say nothing.
 */
export function frontOfSides(root: Object3D, meshes: readonly DrawnMesh[]): Vector3 {
  const places = new Map<string, Vector3>()
  const add = ({ name, matrixWorld }: Object3D) => {
    if (name && !places.has(name)) places.set(name, new Vector3().setFromMatrixPosition(matrixWorld))
  }
  // A mesh's joints may be outside of the root.
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
