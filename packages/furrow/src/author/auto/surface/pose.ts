/** Weights by target index. */
export type Pose = ReadonlyMap<number, number>

/**
 * Converts weights by name to a pose of the skin's targets.
 *
 * @param find maps a name to target indices, none if missing.
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
