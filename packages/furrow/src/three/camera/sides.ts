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

/** Pairs of joints within this angle of the typical pair count, radians. Arms and legs may be in the middle of a step. */
const TYPICAL = Math.PI / 9

/**
 * Finds the facing direction of a character from its left and right joints. Sums the horizontal vectors from each right joint to the left joint
 * of the same pair, without pairs that point elsewhere, and rotates the sum by -90 degrees about +Y.
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
  const pairs: Vector3[] = []
  for (const [name, left] of places) {
    const mirror = MIRRORS.find(([pattern]) => pattern.test(name))
    const right = mirror && places.get(name.replace(...mirror))
    if (right) pairs.push(left.clone().sub(right).setY(0))
  }
  const typical = typicalOf(pairs)
  const across = pairs
    .filter((pair) => pair.angleTo(typical) <= TYPICAL)
    .reduce((sum, pair) => sum.add(pair), new Vector3())
  return new Vector3(-across.z, 0, across.x).normalize()
}

/** Returns the vector with the smallest sum of angles to the others, or a zero vector if there is none. */
function typicalOf(vectors: readonly Vector3[]): Vector3 {
  let [best, least] = [new Vector3(), Infinity]
  for (const vector of vectors) {
    if (vector.length() === 0) continue
    const sum = vectors.reduce((total, other) => total + vector.angleTo(other), 0)
    if (sum < least) [best, least] = [vector, sum]
  }
  return best
}
