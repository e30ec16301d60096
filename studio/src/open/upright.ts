import type { SkinJoint } from 'furrow/author'
import { findWholeBody } from 'furrow/internal'
import { facesOf } from 'furrow/internal/three'
import { Quaternion, Vector3 } from 'three'
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js'
import { jointReader } from './rest-skeleton.ts'

/** Largest angle between two signs of the upward direction, and between their mean and an axis, radians. */
const TOLERANCE = Math.PI / 6

const UP = new Vector3(0, 1, 0)
/** Upward directions of bodies that lie flat. */
const FLAT = [new Vector3(0, 0, 1), new Vector3(0, 0, -1), new Vector3(1, 0, 0), new Vector3(-1, 0, 0)]

/**
 * Turns the scene of a file whose body lies flat, because the file uses Z as its upward axis. Only the stage shows the avatar upright: exported files
 * are made from the original file. Does nothing if the skeleton does not clearly tell which way is up.
 */
export function turnUpright(gltf: GLTF): void {
  const joints = jointReader(gltf.parser)
  const signs = facesOf(gltf, gltf.parser).flatMap(([mesh]) => signsOfUp(joints(mesh) ?? []))
  const up = clearUp(signs)
  if (!up) return
  gltf.scene.quaternion.premultiply(new Quaternion().setFromUnitVectors(up, UP))
  gltf.scene.updateMatrixWorld(true)
}

/** Returns the axis that is up if a body lies flat, and undefined if it stands or the signs differ. */
export function clearUp(signs: readonly Vector3[]): Vector3 | undefined {
  if (signs.length < 2) return undefined
  const mean = signs.reduce((sum, sign) => sum.add(sign), new Vector3())
  const isClear = mean.length() > 0 && signs.every((sign) => sign.angleTo(mean) < TOLERANCE)
  return isClear ? FLAT.find((axis) => axis.angleTo(mean) < TOLERANCE) : undefined
}

/** Returns directions that point upwards in a standing person: along the trunk, the neck, and each leg from the knee to the hip. */
export function signsOfUp(joints: readonly SkinJoint[]): Vector3[] {
  const { neck, limbs, trunk } = findWholeBody(joints)
  const legs = limbs.filter(({ kind }) => kind === 'knee').map(({ hinge, start }) => [hinge, start])
  const chains = [neck, trunk].flatMap((found) => (found ? [[found.base, found.chain.at(-1)!]] : []))
  const placeOf = (joint: number) => {
    const { bind } = joints[joint]
    return new Vector3(bind[12], bind[13], bind[14])
  }
  return [...legs, ...chains]
    .map(([from, to]) => placeOf(to).sub(placeOf(from)).normalize())
    .filter((sign) => sign.length() > 0)
}
