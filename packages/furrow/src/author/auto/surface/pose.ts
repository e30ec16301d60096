/** Weights of targets, by the index of the target. */
export type Pose = ReadonlyMap<number, number>

/**
 * Converts weights by name to a pose.
 *
 * @param find returns the indices of the targets (blendshapes) with a name.
 * @param weights weights by name. Names without a target are ignored.
 */
export function poseOf(
  find: (name: string) => readonly number[],
  weights: Readonly<Record<string, number>>,
): Pose {
  const pairs = Object.entries(weights).flatMap(([name, weight]) =>
    find(name).map((target) => [target, weight] as const),
  )
  return new Map(pairs)
}
