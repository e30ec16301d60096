import type { Viewer } from '../viewer.ts'
import type { Dial } from './dials.ts'

/** Values of dials. The keys are the names of the dials. */
export type Numbers = ReadonlyMap<string, number>

/** Weights of all blendshapes and activations of all areas. */
export interface Pose {
  targets: Numbers
  areas: Numbers
}

export function poseOf({ targets, areas }: Pick<Viewer, 'targets' | 'areas'>): Pose {
  return { targets: numbersOf(targets), areas: numbersOf(areas) }
}

/** Sets the face to a pose. Sets blendshapes first, because they change driven areas. */
export function writePose({ targets, areas }: Pick<Viewer, 'targets' | 'areas'>, pose: Pose): void {
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
