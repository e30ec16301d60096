import { type Camera, type Object3D, Quaternion, Vector3 } from 'three'
import type { PosableJoint } from '../pose/skeleton-pose.ts'

/** Length of the handle at the end of a chain, relative to the bone before it. */
const TIP = 0.6

/** Point that the user drags to turn a bone. */
export interface JointHandle {
  /** Name of the turned joint. */
  readonly name: string
  /** Joint that the handle turns, at the beginning of the bone. */
  readonly turned: Object3D
  /** Writes the position of the handle, at the end of the bone, in world space. */
  read(out: Vector3): Vector3
}

/** Lists the handles of a skeleton, parents first: at each joint below another one, and beyond the last joint of each chain. */
export function handlesOf(joints: readonly PosableJoint[]): readonly JointHandle[] {
  const bones = new Map(joints.map(({ bone, name }) => [bone, name]))
  const parents = new Map(joints.map(({ bone }) => [bone, nearest(bone, bones)]))
  const hasChild = new Set(parents.values())
  return joints.flatMap(({ bone, name }): JointHandle[] => {
    const parent = parents.get(bone)
    const own: JointHandle[] = []
    if (parent)
      own.push({
        name: bones.get(parent)!,
        turned: parent,
        read: (out) => out.setFromMatrixPosition(bone.matrixWorld),
      })
    if (parent && !hasChild.has(bone)) own.push({ name, turned: bone, read: tipOf(bone, parent) })
    return own
  })
}

function nearest(bone: Object3D, bones: ReadonlyMap<Object3D, unknown>): Object3D | undefined {
  for (let above = bone.parent; above; above = above.parent) if (bones.has(above)) return above
  return undefined
}

/** Returns a reader of a point beyond the last joint of a chain, which turns with the joint. */
function tipOf(bone: Object3D, parent: Object3D): JointHandle['read'] {
  const [from, to] = [parent, bone].map((each) => new Vector3().setFromMatrixPosition(each.matrixWorld))
  const tip = bone.worldToLocal(to.clone().addScaledVector(to.clone().sub(from), TIP))
  return (out) => out.copy(tip).applyMatrix4(bone.matrixWorld)
}

/** Turns a joint about the direction in which the camera looks. @param angle radians; positive is counterclockwise on the screen. */
export function turnTowards(joint: Object3D, camera: Camera, angle: number): void {
  const place = new Vector3().setFromMatrixPosition(joint.matrixWorld)
  const axis = new Vector3().setFromMatrixPosition(camera.matrixWorld).sub(place).normalize()
  const above = joint.parent!.getWorldQuaternion(new Quaternion())
  const turn = new Quaternion().setFromAxisAngle(axis, angle)
  joint.quaternion.premultiply(above.clone().invert().multiply(turn).multiply(above)).normalize()
  joint.updateMatrixWorld(true)
}
