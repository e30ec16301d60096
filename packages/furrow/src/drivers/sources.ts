import type { InputOf } from './activation.ts'
import { targetFinder } from './morph/target-names.ts'
import type { InputSource } from './program.ts'

/** Creates an input source whose values are the morph target weights of a mesh, in the order of `targetNames`. */
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

/** Creates an input source whose values are set by the application, one per unique name. `initial` contains the initial values. */
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

/**
 * Creates an input source whose values are measured on the model, one per input.
 *
 * @param missing for each input, the parts that the model lacks, as text for warnings. Empty if the input can be measured.
 */
export function measuredSource(missing: readonly (readonly string[])[]): InputSource {
  return {
    count: missing.length,
    inputs: missing.map((parts, i) => ({ indices: parts.length === 0 ? [i] : [], missing: parts })),
  }
}
