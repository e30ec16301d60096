import type { SkinJoint } from 'furrow/author'
import { Vector3 } from 'three'
import { RIGS, skeletonOf } from './rigs.ts'

/** Angle of the arms below the horizontal in the bind pose, degrees. */
const ARMS_DOWN = 50

/** Skeleton of a robot and of a dress. */
export const PERSON: SkinJoint[] = [...skeletonOf(RIGS['Ready Player Me']!, { armsDown: ARMS_DOWN }).joints]

/** Returns the index of a joint of `PERSON`. */
export function jointOf(name: string): number {
  return PERSON.findIndex((joint) => joint.name === name)
}

/** Returns the position of a joint of `PERSON` in metres. */
export function placeOf(name: string): Vector3 {
  const { bind } = PERSON[jointOf(name)]!
  return new Vector3(bind[12], bind[13], bind[14])
}
