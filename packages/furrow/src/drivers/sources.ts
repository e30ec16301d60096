import type { InputOf } from './activation.ts'
import { targetFinder } from './morph/target-names.ts'
import type { InputSource } from './program.ts'

/** The weights of a mesh's morph targets, in the order of their names. */
export function targetSource(
  inputs: readonly InputOf<'target'>[],
  targetNames: readonly string[],
): InputSource {
  const find = targetFinder(targetNames)
  return {
    count: targetNames.length,
    inputs: inputs.map(({ name }) => {
      const indices = find(name)
      return { indices, missing: indices.length === 0 ? [`target "${name}"`] : [] }
    }),
  }
}

/** What the application sets, one value for each distinct name; `initial` until it is set. */
export function valueSource(
  inputs: readonly InputOf<'value'>[],
): InputSource & { readonly names: readonly string[]; readonly initial: readonly number[] } {
  const initial = new Map<string, number>()
  for (const { name, initial: value = 0 } of inputs) if (!initial.has(name)) initial.set(name, value)
  const names = [...initial.keys()]
  return {
    names,
    initial: [...initial.values()],
    count: names.length,
    inputs: inputs.map(({ name }) => ({ indices: [names.indexOf(name)], missing: [] })),
  }
}

/** A list of measurements, one value for each input. */
export function measuredSource(missing: readonly (readonly string[])[]): InputSource {
  return {
    count: missing.length,
    inputs: missing.map((what, i) => ({ indices: what.length === 0 ? [i] : [], missing: what })),
  }
}
