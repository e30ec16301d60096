import { expressionBinds } from '../../../drivers/morph/vrm-binds.ts'

/**
 * The expressions of a VRM that move one blendshape of a mesh and no other one, fully.
 *
 * @returns their names by the index of the blendshape.
 */
export function soleExpressions(json: unknown, mesh: number): Map<number, string> {
  const found = new Map<number, string>()
  for (const [name, [bind, ...others]] of expressionBinds(json, mesh))
    if (bind?.weight > 0.99 && others.length === 0 && !found.has(bind.index)) found.set(bind.index, name)
  return found
}
