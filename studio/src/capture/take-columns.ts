import { targetFinder } from 'furrow/internal'

/**
 * Finds the blendshapes of a mesh that a take moves.
 *
 * @param names names in the take, in any spelling that drivers accept.
 * @param targets names of the mesh's blendshapes.
 * @returns indices into `names`. The keys are indices into `targets`.
 */
export function columnsOf(names: readonly string[], targets: readonly string[]): ReadonlyMap<number, number> {
  const find = targetFinder(targets)
  return new Map(names.flatMap((name, i) => find(name).map((target): [number, number] => [target, i])))
}
