import type { Expression } from 'furrow'
import { expressionsOf, faceExpressions, targetFinder } from 'furrow/internal'
import type { FaceDrivers } from './face-drivers.ts'

/**
 * Returns the expressions of a face: those in its drivers, those of its VRM, or presets that its blendshapes support. The first expression also
 * resets the blendshapes and areas that it does not name: blendshapes to 0, areas to their activation at rest. It does not reset areas that
 * only drivers set.
 *
 * @param restOf returns the resting activation of an area.
 */
export function completeExpressions(
  drivers: FaceDrivers,
  vrm: readonly Expression[],
  targetNames: readonly string[],
  areaNames: readonly string[],
  restOf: (area: string) => number,
): Expression[] {
  const find = targetFinder(targetNames)
  const [first, ...others] = faceExpressions({
    authored: expressionsOf(drivers.list),
    vrm,
    targetsAmong: (names) => new Set(names.filter((name) => find(name).length > 0)),
    hasArea: (name) => areaNames.includes(name),
  })
  const named = new Set(others.flatMap(({ activations }) => Object.keys(activations)))
  const driven = new Set(drivers.areaNames)
  const set = areaNames.filter((name) => named.has(name) || !driven.has(name))
  const targets = { ...Object.fromEntries(targetNames.map((name) => [name, 0])), ...first.targets }
  const resting = Object.fromEntries(set.map((name) => [name, restOf(name)]))
  return [{ name: first.name, targets, activations: { ...resting, ...first.activations } }, ...others]
}
