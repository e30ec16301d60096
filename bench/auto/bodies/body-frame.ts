import { findWholeBody } from 'furrow/internal'
import { readDocument } from 'furrow-files/node'
import { Quaternion, Vector3 } from 'three'
import type { JointRotation } from '../../../packages/cli/src/render/picture.ts'
import { allSurfaces } from '../../../packages/files/src/mesh/find-skin.ts'
import type { Body } from '../../../packages/furrow/src/author/auto/skeleton/humanoid.ts'

/** Turn of joints about one axis in the bind pose. Each joint of a chain turns by the same share of the angle. */
export interface Turn {
  joints: readonly number[]
  /** Unit axis in the coordinates of the file. */
  axis: Vector3
}

/** Skeleton of a humanoid in its bind pose. */
export interface BodyFrame extends Body {
  /** Returns the position of a joint in the coordinates of the file. */
  placeOf(joint: number): Vector3
  /** Returns the rotations of joints, by name, when turns reach an angle in degrees. */
  pose(turns: readonly Turn[], degrees: number): Record<string, JointRotation>
}

/** @throws Error if the first skinned mesh of the file has no skeleton of a humanoid with two arms, two legs, hands, a neck and a trunk. */
export async function bodyFrame(path: string): Promise<BodyFrame> {
  const surfaces = allSurfaces(await readDocument(path, 'sheets'))
  const { joints = [] } = surfaces.find(({ skin }) => skin.skeleton)?.skin.skeleton ?? {}
  const body = findWholeBody(joints)
  const { hands, limbs, neck, trunk } = body
  if (hands.length !== 2 || limbs.length !== 4 || !neck || !trunk)
    throw new Error(`sheets: no complete humanoid was found, got ${path}`)
  return {
    ...body,
    placeOf: (joint) => new Vector3().fromArray(Array.from(joints[joint]!.bind), 12),
    pose: (turns, degrees) =>
      Object.fromEntries(
        turns.flatMap((turn) =>
          turn.joints.map((joint): [string, JointRotation] => {
            const { name, bind } = joints[joint]!
            const columns = [0, 4, 8].map((first) =>
              new Vector3().fromArray(Array.from(bind), first).normalize(),
            )
            const axis = new Vector3(...columns.map((column) => column.dot(turn.axis)))
            const radians = (degrees * Math.PI) / 180 / turn.joints.length
            return [name, new Quaternion().setFromAxisAngle(axis.normalize(), radians).toArray()]
          }),
        ),
      ),
  }
}
