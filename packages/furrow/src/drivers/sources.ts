import type { InputOf } from './activation.ts'
import { targetFinder } from './morph/target-names.ts'
import type { InputSource } from './program.ts'

/** Creates a source of a mesh's morph target weights, in the order of the names. */
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

/** Creates a source of custom inputs, one value per unique name; `initial` holds the values until they are set. */
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
 * Creates a source of measurements, one value per input.
 *
 * @param missing per input: missing parts of the model, for warnings; empty if the input is measured.
 */
export function measuredSource(missing: readonly (readonly string[])[]): InputSource {
  return {
    count: missing.length,
    inputs: missing.map((parts, i) => ({ indices: parts.length === 0 ? [i] : [], missing: parts })),
  }
}
