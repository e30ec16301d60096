/** Weights by target index. */
export type Pose = ReadonlyMap<number, number>

/**
 * A pose of the targets that a skin has.
 *
 * @param find maps a name to target indices, none for a shape that is missing.
 * @param weights by name.
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
