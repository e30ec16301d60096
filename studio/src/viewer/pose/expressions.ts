import { EXPRESSIONS, type Expression } from 'furrow'
import { expressionsOf } from 'furrow/internal'
import type { FaceDrivers } from './face-drivers.ts'

/**
 * The expressions of a file, or else the presets. The first one names every blendshape, and every area that another one names or nothing
 * drives, so that each expression sets all of them.
 */
export function completeExpressions(
  drivers: FaceDrivers,
  targetNames: readonly string[],
  areaNames: readonly string[],
): Expression[] {
  const own = expressionsOf(drivers.list)
  const [first, ...others] = own.length > 0 ? own : EXPRESSIONS
  const named = new Set(others.flatMap(({ activations }) => Object.keys(activations)))
  const driven = new Set(drivers.areaNames)
  const zeros = (names: readonly string[]) => Object.fromEntries(names.map((name) => [name, 0]))
  const set = areaNames.filter((name) => named.has(name) || !driven.has(name))
  const targets = { ...zeros(targetNames), ...first.targets }
  return [{ name: first.name, targets, activations: { ...zeros(set), ...first.activations } }, ...others]
}
