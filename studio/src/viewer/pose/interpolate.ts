import type { Quaternion } from 'three'

/** Numbers such as values of dials. The keys are names. */
export type Numbers = ReadonlyMap<string, number>

/** Rotations of joints relative to their parents. The keys are names of joints. */
export type JointRotations = ReadonlyMap<string, Quaternion>

/** Interpolates the numbers of `to`. Numbers that `from` lacks start at 0. */
export function interpolateNumbers(from: Numbers, to: Numbers, t: number): Numbers {
  return new Map(
    [...to].map(([name, end]) => [name, t === 1 ? end : (from.get(name) ?? 0) * (1 - t) + end * t]),
  )
}

/** Interpolates the rotations of `to`. Joints that `from` lacks have their rotation at once. */
export function interpolateRotations(from: JointRotations, to: JointRotations, t: number): JointRotations {
  return new Map(
    [...to].map(([name, end]) => {
      const start = from.get(name)
      return [name, start && t < 1 ? start.clone().slerp(end, t) : end]
    }),
  )
}
