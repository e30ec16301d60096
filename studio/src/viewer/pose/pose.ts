import type { Viewer } from '../viewer.ts'
import type { Dial } from './dials.ts'
import type { JointRotations, Numbers } from './interpolate.ts'

/** Weights of all blendshapes, activations of all areas, and rotations of all joints. */
export interface Pose {
  targets: Numbers
  areas: Numbers
  joints: JointRotations
}

type Posed = Pick<Viewer, 'targets' | 'areas' | 'skeleton' | 'move'>

export function poseOf({ targets, areas, skeleton }: Posed): Pose {
  return { targets: numbersOf(targets), areas: numbersOf(areas), joints: skeleton.read() }
}

/** Sets the face to a pose. Sets joints and blendshapes first, because they change driven areas. */
export function writePose(viewer: Posed, pose: Pose): void {
  const { targets, areas, skeleton } = viewer
  const now = skeleton.read()
  if ([...pose.joints].some(([name, rotation]) => !now.get(name)?.equals(rotation)))
    viewer.move(() => skeleton.write(pose.joints))
  writeAll(targets, pose.targets)
  writeAll(areas, pose.areas)
}

function numbersOf(dials: readonly Dial[]): Numbers {
  return new Map(dials.map(({ name, read }) => [name, read()]))
}

function writeAll(dials: readonly Dial[], numbers: Numbers): void {
  for (const dial of dials) {
    const number = numbers.get(dial.name)
    if (number !== undefined && number !== dial.read()) dial.write(number)
  }
}
