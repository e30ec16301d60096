import { REST_POSE } from './pose/skeleton-pose.ts'
import type { Viewer } from './viewer.ts'

/** Expression of the face or pose of joints, with a button in the bar below the stage. */
export interface ShownPose {
  readonly kind: 'expression' | 'pose'
  readonly name: string
}

/** Lists the expressions of a face, and then the poses of its joints, which begin with the rest pose. */
export function shownPoses({ targets, expressions, skeleton }: Viewer): readonly ShownPose[] {
  const ofFace = targets.length > 0 ? expressions : []
  const ofJoints = skeleton.poses.length > 0 ? [{ name: REST_POSE }, ...skeleton.poses] : []
  return [
    ...ofFace.map(({ name }) => ({ kind: 'expression' as const, name })),
    ...ofJoints.map(({ name }) => ({ kind: 'pose' as const, name })),
  ]
}
